// SPDX-License-Identifier: MIT
// What do many built-in scenes have in common?
#pragma once
#include <numbers>
#include <string>

#include <compare/scene/scene.h>
#include <plumb/math/trig.h>

namespace plumb::compare {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

inline constexpr double degrees(double angle) {
    return angle * std::numbers::pi / 180;
}

/// The unit vector at an angle from +x, with the same bits on every machine.
inline Vec2 direction(double angle) {
    const SinCos turned = sinCos(angle);
    return {turned.cos, turned.sin};
}

/// The density that gives a disc its mass [kg/m^2].
inline constexpr double discDensity(double mass, double radius) {
    return mass / (std::numbers::pi * radius * radius);
}

/// The reason why a body on another body is never exactly on its surface. A disc on one point sinks by half of g / w^2,
/// and a box on two corners by 5/8. A box between boxes, which both give way, sinks by 5/4 for each weight it carries.
inline const std::string sinksOnGround =
    "a contact with the ground gives way to its load as a spring of 60 Hz, g / (2 pi 60)^2 = 0.07 mm: ";
inline const std::string sinks =
    "a contact of two bodies gives way to its load as a spring of 30 Hz, g / (2 pi 30)^2 = 0.28 mm: ";

/// A level floor at y = 0, 20 m wide.
inline SceneBody floorBody() {
    return {"floor", {.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}}};
}

/// A point to hang things from; nothing collides with it.
inline SceneBody pivotBody(const Vec2& position) {
    ShapeDef mark = circle(0.05);
    mark.filter.mask = 0;
    return {"pivot", {.type = BodyType::Static, .position = position, .shapes = {mark}}};
}

/// A check for Plumb alone.
inline Check invariant(const std::string& metric, double limit, const std::string& reason) {
    return InvariantCheck{.metric = metric, .limit = limit, .reason = reason};
}

}  // namespace plumb::compare
