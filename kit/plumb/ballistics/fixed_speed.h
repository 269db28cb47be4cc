// SPDX-License-Identifier: MIT
// How must a shot of a given speed be aimed to hit a target?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct Aim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double speed = 0;        ///< of the shot when it leaves the muzzle, >= 0 [m/s]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// None, one or two shots: the low arc first, then the high one.
///   t_low = D sqrt(2 / (B + S)),  t_high = sqrt(2 (B + S)) / |g|,  S^2 = (v^2 - m) (B + |g| D)
///   u = d / t - g t / 2,  B = v^2 + g . d,  m = |g| D - g . d = (g x d)^2 / (|g| D + g . d)
/// d target [m], D its distance [m], v speed [m/s], g gravity [m/s^2], m square of the least speed [m^2/s^2], t time
/// [s], u velocity [m/s]. No subtraction loses digits, and as gravity goes to 0 the time of the low arc goes to D / v.
/// A speed within 1e-15 of the least speed counts as equal to it: one shot. Without gravity there is no high arc. A
/// target at the muzzle is hit at once, by one shot straight up. Shots whose time would not be finite are left out.
/// Throws std::invalid_argument on input out of range (shot.h).
/// Source: |d / t - g t / 2| = v, squared, is quadratic in t^2; the lecture, slides 13-16, with the cases that are
/// missing there. Tests: "a million shots of fixed speed hit, by both arcs", "the slowest shot's own speed has a shot,
/// a million times"
std::vector<Shot> aim(const Aim& problem);

}  // namespace plumb
