// SPDX-License-Identifier: MIT
// How must a shot that flies in a straight line be aimed: a beam, or a fast bullet?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct BeamAim {
    Vec2 target{0, 0};           ///< its position at the launch, from the muzzle [m]
    Vec2 targetVelocity{0, 0};   ///< constant [m/s]
    Vec2 shooterVelocity{0, 0};  ///< added to the velocity of the shot [m/s]
    double speed = 0;            ///< of the shot relative to the shooter, >= 0 [m/s]
};

/// The earliest shot that hits; empty when the target is too fast. To find obstacles, cast a ray from the muzzle along
/// velocity * time.
///   t = D^2 / (S - d . w),  S^2 = (v D - |d x w|) (v D + |d x w|)
/// d target [m], D its distance [m], w its velocity minus the shooter's, v speed [m/s], t time [s]
/// A target at the muzzle is hit at once, by a shot to +x.
/// Throws std::invalid_argument on input out of range (shot.h).
/// Source: |d + w t| = v t, squared, is quadratic in 1 / t; this includes v = |w|.
/// Test: "a million beams hit, and where there is none the target outruns every point it could be met at"
std::optional<Shot> aimBeam(const BeamAim& problem);

}  // namespace plumb
