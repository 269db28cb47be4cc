// SPDX-License-Identifier: MIT
// How must a shot of a given speed be aimed at a moving target, from a moving shooter?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct MovingAim {
    Vec2 target{0, 0};           ///< its position at the launch, from the muzzle [m]
    Vec2 targetVelocity{0, 0};   ///< constant [m/s]
    Vec2 shooterVelocity{0, 0};  ///< added to the velocity of the shot [m/s]
    double speed = 0;            ///< of the shot relative to the shooter, >= 0 [m/s]
    Vec2 gravity{0, -9.81};      ///< for the shot; the target is not affected [m/s^2]
};

/// All shots that hit, up to four, the earliest first.
///   |d + w t - g t^2 / 2| = v t,  u = d / t + w - g t / 2 + s
/// d target [m], w its velocity minus the shooter's, v speed, s the shooter's velocity, u the shot's [m/s], g gravity
/// [m/s^2], t time [s]. Squared it is a quartic in t:
///   g^2 t^4 / 4 - (g . w) t^3 + (w^2 - g . d - v^2) t^2 + 2 (d . w) t + d^2 = 0
/// Its extrema, found from those of its derivatives, bracket each root, which is then refined on the equation that is
/// not squared. Without gravity it is a quadratic, as for a beam. Two roots so close that rounding decides between none
/// and two count as one. A target at the muzzle is hit at once, by one shot straight up. Shots that take more than 1e70
/// s are left out. Throws std::invalid_argument on input out of range (shot.h). Tests: "a million shots at moving
/// targets hit, and a scan over time finds no other", "a target as fast as the shot is met, whether gravity is none,
/// next to none, or some"
std::vector<Shot> aimAtMoving(const MovingAim& problem);

}  // namespace plumb
