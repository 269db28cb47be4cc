// SPDX-License-Identifier: MIT
// How are forces computed from input that has been checked before?
#pragma once
#include <cmath>

#include <plumb/forces/buoyancy.h>
#include <plumb/forces/gravity.h>

namespace plumb {

/// As submergedPart, unchecked.
Submerged submergedPartOf(std::span<const Vec2> corners, double radius, const Fluid& fluid);

/// As gravityForce, unchecked.
inline Vec2 gravityForceOf(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    const Vec2 d = b.position - a.position;
    const double r = std::sqrt(d.squaredNorm() + gravity.softening * gravity.softening);
    const double pull = gravity.constant * (a.mass * b.mass) / (r * r * r);  // the same bits for either body
    if (!std::isfinite(pull)) return {0, 0};                                 // same position, or overflow
    return -pull * d;
}

}  // namespace plumb
