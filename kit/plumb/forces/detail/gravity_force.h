// SPDX-License-Identifier: MIT
// How does one mass pull another, when both are known to be sound?
#pragma once
#include <cmath>

#include <plumb/forces/gravity.h>

namespace plumb {

/// As gravityForce, unchecked.
inline Vec2 gravityForceOf(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    const Vec2 d = b.position - a.position;
    const double r = std::sqrt(d.squaredNorm() + gravity.softening * gravity.softening);
    const double pull = gravity.constant * (a.mass * b.mass) / (r * r * r);  // the same bits from either side
    if (!std::isfinite(pull)) return {0, 0};                                 // at one place, or too near for numbers
    return -pull * d;
}

}  // namespace plumb
