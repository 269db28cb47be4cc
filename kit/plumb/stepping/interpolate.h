// SPDX-License-Identifier: MIT
// Where is an object between two ticks?
#pragma once
#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/transform.h>

namespace plumb {

// Each takes the values at two ticks and the fraction of the interval between them [-], 0 to 1: 0 gives the first,
// exactly, 1 the second, to rounding. Each throws std::invalid_argument on a fraction outside. If drawing interpolates
// at this fraction, the world is shown one interval late, and moves smoothly at any display rate.

inline double interpolate(double from, double to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * (to - from);
}
inline Vec2 interpolate(const Vec2& from, const Vec2& to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * (to - from);
}

/// The smallest rotation from one angle to another, within -pi to pi [rad].
inline double shortestTurn(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);  // exact by definition, so the same everywhere
}

/// Along the shortest rotation [rad]: from 3 to -3 it passes pi, by 0.28, and ends at 3.28. A rotation of more than
/// half a turn per tick cannot be distinguished from one in the opposite direction; for that use interpolate() with
/// angles that count whole turns. Test: "an angle takes the shorter way round"
inline double interpolateAngle(double from, double to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * shortestTurn(from, to);
}

/// The position along a straight line, the rotation at a constant rate along the shortest rotation.
/// Test: "a pose turns evenly the shorter way while it moves straight"
inline Transform interpolate(const Transform& from, const Transform& to, double fraction) {
    const Rot turn = from.rotation.inverse() * to.rotation;
    return {interpolate(from.position, to.position, fraction), from.rotation * Rot::fromAngle(fraction * turn.angle())};
}

}  // namespace plumb
