// SPDX-License-Identifier: MIT
// When can an object that flies in a straight line at a given speed intercept a target with constant velocity?
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <plumb/ballistics/detail/gravity_frame.h>
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
inline Intercepts straightIntercepts(const Vec2& d, const Vec2& w, double v) {
    Intercepts found;
    const double distance = lengthOf(d), speed = lengthOf(w);
    // Components of the target's velocity: away from the muzzle, and across. The latter has a rounding error of about
    // 1e-16 of w.
    const Vec2 n = directionOf(d);
    const double away = n.dot(w), aside = std::fabs(cross(n, w));
    if (v - aside < -1e-15 * speed) return found;
    const double root = std::sqrt(std::max(0.0, v - aside)) * std::sqrt(v + aside);
    const auto add = [&](double closing) {
        const double time = distance / closing;
        if (closing > 0 && std::isfinite(time)) found.intercepts[found.count++] = {time, closing};
    };
    // No sum of terms with different signs: the product of the two solutions is w^2 - v^2.
    add(away <= 0 ? root - away : (v - speed) * ((v + speed) / (root + away)));
    if (away < 0 && root > 0) add((speed - v) * ((speed + v) / (root - away)));
    return found;
}

}  // namespace plumb::detail
