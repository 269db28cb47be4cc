// SPDX-License-Identifier: MIT
#include <plumb/ballistics/detail/straight_intercepts.h>

#include <algorithm>
#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>

namespace plumb::detail {

Intercepts straightIntercepts(const Vec2& d, const Vec2& w, double v) {
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
