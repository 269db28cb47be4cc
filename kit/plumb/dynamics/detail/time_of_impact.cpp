// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/time_of_impact.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/continuous.h>

namespace plumb {

namespace {

/// Nearer than this is a touch: a thousand roundings of a metre [m].
constexpr double touch = 1e-12;
/// Already touching at the start, by so much that an impact of the step before may have left [m].
constexpr double resting = 1e-9;
/// Where they touch and part, the search goes on after this share of what is left of the step, or of the time in which
/// the two could come half through each other [-].
constexpr double pastTouch = 1e-2;
/// From here on Newton's method is quicker than safe steps; as a share of the extents [-].
constexpr double near = 1e-2;

Transform poseOf(const FlyingShape& s, const BodyMotion& motion) {
    return {motion.center - motion.rotation * s.localCenter, motion.rotation};
}

Vec2 velocityAt(const BodyMotion& motion, const Vec2& point) {
    return motion.velocity + perp(Vec2(point - motion.center)) * motion.angularVelocity;
}

/// Faster than this the two cannot approach at any time in the rest of the step.
double greatestClosingSpeed(const FlyingShape& a, const FlyingShape& b, const Encounter& now, double left) {
    const auto turning = [left](const FlyingShape& s, const BodyMotion& m) {
        return (std::fabs(m.angularVelocity) + std::fabs(s.law.acceleration.angular) * left) * s.extent;
    };
    const auto pull = [](const FlyingShape& s, const BodyMotion& m) -> Vec2 {
        return s.law.acceleration.linear - m.velocity * s.law.linearDamping;
    };
    const double relative = (now.b.velocity - now.a.velocity).norm();
    const double change = (pull(b, now.b) - pull(a, now.a)).norm() * left;
    return relative + change + turning(a, now.a) + turning(b, now.b);
}

/// Between a time before the touch and one after it: to the last bit that matters, on the near side.
double bisect(const FlyingShape& a, const FlyingShape& b, double before, double after) {
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after) break;
        const double separation = encounterAt(a, b, middle).distance.separation;
        if (separation >= 0 && separation <= touch) return middle;
        (separation > 0 ? before : after) = middle;
    }
    return before;
}

}  // namespace

Encounter encounterAt(const FlyingShape& a, const FlyingShape& b, double time) {
    Encounter e;
    e.a = fly(a.from, a.law, time - a.time);
    e.b = fly(b.from, b.law, time - b.time);
    e.distance = distance(*a.shape, poseOf(a, e.a), *b.shape, poseOf(b, e.b));
    const Vec2 relative = velocityAt(e.b, e.distance.pointB) - velocityAt(e.a, e.distance.pointA);
    e.closingSpeed = -relative.dot(e.distance.normal);
    return e;
}

std::optional<double> timeOfImpact(const FlyingShape& a, const FlyingShape& b, double from, double to) {
    double time = from;
    const double scale = std::max(a.extent, b.extent);
    for (int i = 0; i < 1000; ++i) {
        const Encounter now = encounterAt(a, b, time);
        const double separation = now.distance.separation;
        if (separation <= (i == 0 ? resting : touch)) {
            if (now.closingSpeed > 0) return time;
            const bool turns = now.a.angularVelocity != 0 || now.b.angularVelocity != 0;
            if (i == 0 && !turns) return std::nullopt;  // they part, and nothing brings them together again
            const double thick = 0.5 * (coreOf(*a.shape) + coreOf(*b.shape));
            const double part = std::min(to - time, thick / greatestClosingSpeed(a, b, now, to - time));
            time += std::max((thick > 0 ? part : to - time) * pastTouch, to * 1e-12);
            if (time >= to) return std::nullopt;
            continue;
        }
        const double fastest = greatestClosingSpeed(a, b, now, to - time);
        double step = fastest > 0 ? separation / fastest : to - time;
        const bool newton = separation < near * scale && now.closingSpeed > 0.01 * fastest;
        if (newton) step = separation / now.closingSpeed;
        if (time + step >= to && !newton) return std::nullopt;
        const double next = std::min(time + std::max(step, (to - from) * 1e-12), to);
        const double ahead = encounterAt(a, b, next).distance.separation;
        if (ahead < 0) return bisect(a, b, time, next);
        if (next >= to) return ahead <= touch && now.closingSpeed > 0 ? std::optional<double>(to) : std::nullopt;
        time = next;
    }
    return time;
}

}  // namespace plumb
