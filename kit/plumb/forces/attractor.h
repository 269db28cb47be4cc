// SPDX-License-Identifier: MIT
// How does a point attract objects?
#pragma once
#include <limits>

#include <plumb/math/vec2.h>

namespace plumb {

/// A central force by a power of the distance: a simple magnet, a black hole, a charge.
struct Attractor {
    Vec2 center{0, 0};                                       ///< [m]
    double strength = 1;                                     ///< S: negative repels [N m^n]
    int power = 2;                                           ///< n, 1 to 8 [-]
    double softening = 0;                                    ///< s: below it the force hardly grows; >= 0 [m]
    double range = std::numeric_limits<double>::infinity();  ///< R: no force beyond it, > 0 [m]
};

/// F = -S d / (d^2 + s^2)^((n + 1) / 2) [N], which is S / d^n without softening; none beyond the range
/// d from the centre to the position [m]. At the centre there is no direction, and the force is 0.
/// Source: central forces; the softening is as in MutualGravity. Throws std::invalid_argument on a power outside
/// 1 to 8, on a strength that is not finite, on a softening that is negative or not finite, and on a range that is
/// not positive. Tests: "1 kg on a circle around any power of the distance is back after one turn",
///        "what crosses the edge of an attractor's range and comes out again keeps its energy"
Vec2 attraction(const Attractor& attractor, const Vec2& position);

/// U = -S / ((n - 1) q^(n - 1)), S ln(q / 1 m) for n = 1;  q = sqrt(d^2 + s^2) [m]
/// With a range, its value there is subtracted: it is 0 from there on, without a step, so that a body that crosses the
/// edge keeps its energy. Without a range it is 0 far away (n = 1: at q = 1 m). Without softening it is infinite at the
/// centre. Test: "the slope of every potential energy is its force, in 100,000 places each"
double potentialEnergy(const Attractor& attractor, const Vec2& position);

}  // namespace plumb
