// SPDX-License-Identifier: MIT
// Where is an oblique shot with drag proportional to the square of its speed at its apex, at its landing, and at any
// time?
#pragma once
#include <optional>

#include <plumb/ballistics/quadratic_drag.h>
#include <plumb/math/vec2.h>

namespace plumb {

struct FlightPoint {
    Vec2 position{0, 0};  ///< from the muzzle [m]
    Vec2 velocity{0, 0};  ///< [m/s]
    double time = 0;      ///< since the launch [s]
};

/// The state after a time >= 0 [s], in still air, with gravity down along -y. Empty when a number would not be finite.
///   u' = (0, -g) - c |u| u
/// u velocity [m/s], g gravity [m/s^2], c coefficient [1/m]. There is no closed form: it is integrated by
/// integrate/integrate.h, with an error of 1e-11 of the size of the trajectory. From 45 V / g on, V the terminal speed
/// [m/s], it falls straight at V: the velocity differs from that by less than 1e-19 of it. Without drag it is the
/// parabola. In a steady wind W, give u - W, and add W t to the position and W to the velocity.
/// Throws std::invalid_argument on input out of range (shot.h), as both below.
/// Tests: "an oblique flight through quadratic drag is that of 100,000 small steps", "a vertical flight through
/// quadratic drag is the closed form's"
std::optional<FlightPoint> quadraticDragFlight(const Vec2& velocity, double time, const QuadraticDrag& drag);

/// The highest point; empty when the shot does not rise. Straight up, the closed form is shootUp().
std::optional<FlightPoint> quadraticDragApex(const Vec2& velocity, const QuadraticDrag& drag);

/// Where the shot lands on horizontal ground at a height below the muzzle (negative: above it) [m]: position.x() is its
/// range. Empty when it never does. A shot that starts on the ground, and not upward, has landed at once.
std::optional<FlightPoint> quadraticDragLanding(const Vec2& velocity, double height, const QuadraticDrag& drag);

}  // namespace plumb
