// SPDX-License-Identifier: MIT
// When can an object that flies in a straight line at a given speed intercept a target with constant velocity?
#pragma once
#include <array>
#include <cstddef>

#include <plumb/ballistics/shot.h>

namespace plumb::detail {

struct Intercepts {
    struct Intercept {
        double time = 0;     ///< [s]
        double closing = 0;  ///< mean closing speed: distance over time [m/s]
    };
    std::array<Intercept, 2> intercepts{};  ///< the earlier first
    std::size_t count = 0;                  ///< two where the target is faster, approaches and then moves away
};

/// d target, farther away than muzzle [m], w its velocity minus the shooter's, v speed of the shot [m/s].
///   closing = -w . d / |d| +- S,  S^2 = v^2 - (d x w)^2 / d^2
/// A target out of reach by no more than rounding counts as reached, once.
Intercepts straightIntercepts(const Vec2& d, const Vec2& w, double v);

}  // namespace plumb::detail
