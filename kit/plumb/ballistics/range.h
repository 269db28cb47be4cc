// SPDX-License-Identifier: MIT
// How high does a shot rise, where does it land, and which shot has the greatest range?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct Launch {
    Vec2 velocity{0, 0};     ///< [m/s]
    double height = 0;       ///< of the muzzle above the ground; negative below it [m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// The highest point; empty when the shot does not rise, or is not pulled back.
///   t = -(u . g) / g^2
/// u velocity [m/s], g gravity [m/s^2], t time [s]. Throws std::invalid_argument on input out of range (shot.h).
/// Test: "100,000 apexes and landings are where a path looked at in small steps has them"
std::optional<PathPoint> apexOf(const Launch& launch);

/// Where the shot lands on horizontal ground; empty when it never does.
///   t = (w + sqrt(w^2 + 2 |g| h)) / |g|
/// w upward velocity [m/s], h height [m], g gravity [m/s^2], t time [s]. A shot that starts on the ground, and not
/// upward, has landed at once. Throws and test as above.
std::optional<PathPoint> landingOf(const Launch& launch);

struct RangeAim {
    double speed = 0;        ///< >= 0 [m/s]
    double height = 0;       ///< of the muzzle above the ground; negative below it [m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

struct GreatestRange {
    double range = 0;  ///< along the ground [m]
    Shot shot;         ///< the shot with that range, to the right when up is against gravity
};

/// The greatest range of a shot of a given speed along horizontal ground; empty when it does not rise up to the ground,
/// and without gravity.
///   R = (v / |g|) sqrt(v^2 + 2 |g| h),  tan a = v / sqrt(v^2 + 2 |g| h)
/// R range [m], v speed [m/s], g gravity [m/s^2], h height [m], a angle above the horizontal [rad]
/// Throws std::invalid_argument on input out of range (shot.h).
/// Source: the envelope of all shots of that speed, y = v^2 / (2 g) - g x^2 / (2 v^2), at y = -h.
/// Test: "no angle of 100,000 goes further than the greatest range"
std::optional<GreatestRange> greatestRange(const RangeAim& problem);

}  // namespace plumb
