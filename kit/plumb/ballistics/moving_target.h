// SPDX-License-Identifier: MIT
// How must a shot of a given speed be aimed at a target that moves, from a shooter that moves?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct MovingAim {
    Vec2 target{0, 0};           ///< where it is at the launch, from the muzzle [m]
    Vec2 targetVelocity{0, 0};   ///< it stays as it is [m/s]
    Vec2 shooterVelocity{0, 0};  ///< the shot has it as well [m/s]
    double speed = 0;            ///< of the shot as the shooter sees it, >= 0 [m/s]
    Vec2 gravity{0, -9.81};      ///< of the shot; the target has none [m/s^2]
};

/// All shots that hit, up to four, the earliest first.
///   |d + w t - g t^2 / 2| = v t,  u = d / t + w - g t / 2 + s
/// d target [m], w its velocity less the shooter's, v speed, s the shooter's velocity, u the shot's [m/s], g
/// gravity [m/s^2], t time [s]. Squared it is a quartic in t:
///   g^2 t^4 / 4 - (g . w) t^3 + (w^2 - g . d - v^2) t^2 + 2 (d . w) t + d^2 = 0
/// between whose extremes, found from those of its derivatives, each root is bracketed and then refined on the
/// equation that is not squared. Without gravity it is a quadratic, as for a beam. Two that lie so close that rounding
/// decides between none and two count as one. A target at the muzzle is hit at once, by one shot straight up. Shots
/// that take more than 1e70 s are left out. Throws std::invalid_argument on input out of range (shot.h). Tests: "a
/// million shots at moving targets hit, and a scan over time finds no other", "a target as fast as the shot is met,
/// whether gravity is none, next to none, or some"
std::vector<Shot> aimAtMoving(const MovingAim& problem);

}  // namespace plumb
