// SPDX-License-Identifier: MIT
#include <compare/scene/random/style.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/logarithm.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

constexpr Form allForms[] = {Form::Disc,      Form::Capsule, Form::Box,     Form::Regular,
                             Form::Irregular, Form::Rounded, Form::Compound};
constexpr double smallestRadius = 0.1;  // as bodies.h requires [m]

/// The largest radius at which a crowd fills no more than about 60 m by 60 m: from higher up it would not land in 5 s.
double largestRadius(int count) {
    return std::min(4.0, 100 / std::sqrt(count));
}

double drawRatio(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    if (kind < 0.4) return draw.uniform(1, 1.5);
    if (kind < 0.75) return draw.logUniform(1.5, 5);
    return draw.logUniform(5, 30);
}

std::vector<Form> drawForms(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    if (kind < 0.35) return {std::begin(allForms), std::end(allForms)};
    const int count = kind < 0.6 ? 1 : draw.integer(2, 3);
    std::vector<Form> forms;
    for (int i = 0; i < count; ++i) forms.push_back(draw.of(allForms));
    return forms;
}

Range drawFriction(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    if (kind < 0.15) return {0, 0.1};
    if (kind < 0.75) return {0.3, 0.8};
    return {0, 1.2};
}

Range drawRestitution(Draw& draw) {
    const double kind = draw.uniform(0, 1);
    if (kind < 0.5) return {0, 0};
    if (kind < 0.8) return {0, 0.4};
    return {0.2, 0.9};
}

Range drawDensity(Draw& draw) {
    constexpr double densities[] = {1, 10, 100, 1000};
    const double density = draw.of(densities);
    if (!draw.chance(0.3)) return {density, density};
    return {density, density * draw.uniform(2, 10)};
}

}  // namespace

Style drawStyle(Draw& draw, int count) {
    Style style;
    const double low = draw.logUniform(smallestRadius, 0.5), ratio = drawRatio(draw);
    style.radius.high = std::min(low * ratio, largestRadius(count));
    style.radius.low = std::max(smallestRadius, style.radius.high / ratio);
    style.mostlySmall = ratio > 3;
    style.forms = drawForms(draw);
    style.friction = drawFriction(draw);
    style.restitution = drawRestitution(draw);
    style.density = drawDensity(draw);
    style.upright = draw.chance(0.25);
    if (draw.chance(0.25)) style.speed = draw.uniform(0, 5);
    if (draw.chance(0.25)) style.spin = draw.uniform(0, 3);
    return style;
}

double drawRadius(Draw& draw, const Style& style) {
    double share = draw.uniform(0, 1);
    if (style.mostlySmall) share = share * share * share;
    const auto& [low, high] = style.radius;
    return std::clamp(low * exponential(share * logarithm(high / low)), low, high);
}

Material drawMaterial(Draw& draw, const Style& style) {
    Material material;
    material.density = draw.uniform(style.density.low, style.density.high);
    material.friction = draw.uniform(style.friction.low, style.friction.high);
    material.restitution = draw.uniform(style.restitution.low, style.restitution.high);
    return material;
}

}  // namespace plumb::compare
