// SPDX-License-Identifier: MIT
// At which speed does a barrel with a given angle hit a target?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct AngleAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double angle = 0;        ///< of the barrel, counter-clockwise from +x [rad]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// The single speed that hits; empty when there is none, or when any would do: without gravity, or straight along it.
///   t^2 = 2 (n x d) / (n x g),  v = (d x g) / (t (n x g))
/// which for gravity g downward is v^2 = g x^2 / (2 cos^2 a (x tan a - y))
/// n direction of the barrel [-], d target [m], g gravity [m/s^2], t time [s], v speed [m/s], a angle [rad]
/// Throws std::invalid_argument on input out of range (shot.h).
/// Source: the components of d = v n t + g t^2 / 2 across n and across g.
/// Test: "a million shots at fixed angles hit, and where there is none the target is not below the line of the
/// barrel"
std::optional<Shot> aimAtAngle(const AngleAim& problem);

}  // namespace plumb
