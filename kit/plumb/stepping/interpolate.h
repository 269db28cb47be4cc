// SPDX-License-Identifier: MIT
// Where is an object between two ticks?
#pragma once
#include <plumb/math/transform.h>

namespace plumb {

// Each takes the values at two ticks and the fraction of the interval between them [-], 0 to 1: 0 gives the first,
// exactly, 1 the second, to rounding. Each throws std::invalid_argument on a fraction outside. If drawing interpolates
// at this fraction, the world is shown one interval late, and moves smoothly at any display rate.

double interpolate(double from, double to, double fraction);
Vec2 interpolate(const Vec2& from, const Vec2& to, double fraction);

/// The smallest rotation from one angle to another, within -pi to pi [rad].
double shortestTurn(double from, double to);

/// Along the shortest rotation [rad]: from 3 to -3 it passes pi, by 0.28, and ends at 3.28. A rotation of more than
/// half a turn per tick cannot be distinguished from one in the opposite direction; for that use interpolate() with
/// angles that count whole turns. Test: "an angle takes the shorter way round"
double interpolateAngle(double from, double to, double fraction);

/// The position along a straight line, the rotation at a constant rate along the shortest rotation.
/// Test: "a pose turns evenly the shorter way while it moves straight"
Transform interpolate(const Transform& from, const Transform& to, double fraction);

}  // namespace plumb
