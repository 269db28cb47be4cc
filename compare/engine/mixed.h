// SPDX-License-Identifier: MIT
// What is the coefficient of a pair of materials, if an engine leaves the rule to its user?
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>

#include <plumb/space/shape_def.h>

namespace plumb::compare {

/// If two materials have different rules, the one that is later in Mix applies.
inline Mix ruleOf(Mix a, Mix b) {
    return std::max(a, b);
}

/// The coefficient in the precision of the engine that needs it.
template <std::floating_point Number>
Number mixed(Mix rule, Number a, Number b) {
    switch (rule) {
        case Mix::Average: return (a + b) / 2;
        case Mix::Minimum: return std::min(a, b);
        case Mix::Product: return a * b;
        case Mix::Maximum: return std::max(a, b);
        case Mix::GeometricMean: break;
    }
    return std::sqrt(a * b);
}

/// True if both coefficients are mixed as in Box2D.
inline bool mixesAsBox2d(const Material& material) {
    return material.frictionMix == Mix::GeometricMean && material.restitutionMix == Mix::Maximum;
}

}  // namespace plumb::compare
