// SPDX-License-Identifier: MIT
#include <plumb/ballistics/detail/straight_meetings.h>

#include <algorithm>
#include <cmath>

#include <plumb/ballistics/detail/level.h>

namespace plumb::detail {

StraightMeetings straightMeetings(const Vec2& d, const Vec2& w, double v) {
    StraightMeetings found;
    const double distance = lengthOf(d), speed = lengthOf(w);
    // Parts of the target's velocity: away from the muzzle, and across. Of the latter rounding leaves some 1e-16 of w.
    const Vec2 n = directionOf(d);
    const double away = n.dot(w), aside = std::fabs(cross(n, w));
    if (v - aside < -1e-15 * speed) return found;
    const double root = std::sqrt(std::max(0.0, v - aside)) * std::sqrt(v + aside);
    const auto add = [&](double closing) {
        const double time = distance / closing;
        if (closing > 0 && std::isfinite(time)) found.meetings[found.count++] = {time, closing};
    };
    // No sum of what has two signs: the product of the two solutions is w^2 - v^2.
    add(away <= 0 ? root - away : (v - speed) * ((v + speed) / (root + away)));
    if (away < 0 && root > 0) add((speed - v) * ((speed + v) / (root - away)));
    return found;
}

}  // namespace plumb::detail
