// SPDX-License-Identifier: MIT
// May two shapes touch, and with which coefficients, if an engine leaves the rule to its user?
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>

#include <plumb/space/shape_def.h>

namespace plumb::compare {

/// The rule of the kit and of most engines. Shapes of the same group always touch, or never if the group is negative.
/// For other shapes, category and mask decide.
inline bool accepts(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

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

/// True if friction is the geometric mean and restitution the larger one: the rules of most engines.
inline bool mixesAsUsual(const Material& material) {
    return material.frictionMix == Mix::GeometricMean && material.restitutionMix == Mix::Maximum;
}

}  // namespace plumb::compare
