// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/time_of_impact.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/dynamics/bodies/shape_radii.h>

namespace plumb {

namespace {

/// Nearer than this is a touch: a thousand roundings of a metre [m].
constexpr double touch = 1e-12;
/// Already touching at the start, by so much that an impact of the step before may have left [m].
constexpr double resting = 1e-9;
/// The search always goes on by this share of the time in which the two could come half through each other: where they
/// touch and part, or hardly part but spin, safe steps would be too many. What touches and parts again in that time is
/// less deep than the same share of its thickness [-].
constexpr double always = 1e-2;
/// From here on Newton's method is quicker than safe steps; as a share of the extents [-].
constexpr double near = 1e-2;

Transform poseOf(const FlyingShape& s, const BodyMotion& motion) {
    return {motion.center - motion.rotation * s.localCenter, motion.rotation};
}

/// A bound on how two shapes approach along a normal: by no more than speed * t + bend / 2 * t^2 in a time t [m].
struct ClosingBound {
    double speed = 0, bend = 0;  ///< [m/s, m/s^2]

    /// So long they stay apart that are separation apart [s].
    double safeTime(double separation) const {
        const double fast = speed + std::sqrt(std::max(speed * speed + 2 * bend * separation, 0.0));
        return fast > 0 ? 2 * separation / fast : std::numeric_limits<double>::infinity();
    }
};

struct Pull {
    Vec2 linear{0, 0};
    double angular = 0;
};

Pull pullOn(const FlyingShape& s, const BodyMotion& now) {
    return {s.law.acceleration.linear - now.velocity * s.law.linearDamping,
            s.law.acceleration.angular - now.angularVelocity * s.law.angularDamping};
}

/// Of b towards a, as seen from a, which turns: only then does the spin of a large body count by how near the other is.
/// What is left of the step is the time for which it holds.
ClosingBound approachTo(const FlyingShape& a, const FlyingShape& b, const BodyMotion& nowA, const BodyMotion& nowB,
                        const Vec2& normal, double left) {
    const Pull pullA = pullOn(a, nowA), pullB = pullOn(b, nowB);
    const Vec2 between = nowB.center - nowA.center, relative = nowB.velocity - nowA.velocity;
    const double uneven = std::fabs(b.law.linearDamping - a.law.linearDamping) * pullA.linear.norm() * left;
    const double pull = (pullB.linear - pullA.linear).norm() + uneven;
    const double swing = std::fabs(pullA.angular), spin = std::fabs(nowA.angularVelocity) + swing * left;
    const double fastest = relative.norm() + pull * left;
    const double farthest = between.norm() + fastest * left;
    const double turn =
        std::fabs(nowB.angularVelocity - nowA.angularVelocity) + (swing + std::fabs(pullB.angular)) * left;
    const double closing = (perp(between) * nowA.angularVelocity - relative).dot(normal);
    return {closing + turn * turningRadiusOf(*b.shape, b.localCenter),
            pull + swing * farthest + spin * (2 * fastest + spin * farthest)};
}

/// As seen from the larger one.
ClosingBound approachIn(const FlyingShape& a, const FlyingShape& b, const Encounter& now, double left) {
    if (a.boundingRadius >= b.boundingRadius) return approachTo(a, b, now.a, now.b, now.distance.normal, left);
    return approachTo(b, a, now.b, now.a, -now.distance.normal, left);
}

/// Between a time before the touch and one after it: to the last bit that matters, on the near side.
/// Regula falsi, an end that stays twice being halved in weight; where that makes no way, the middle.
/// Source: Dowell and Jarratt, "A modified regula falsi method", 1971.
double bracketed(const FlyingShape& a, const FlyingShape& b, double before, double separationBefore, double after,
                 double separationAfter) {
    double outside = separationBefore, inside = separationAfter;
    int side = 0;
    for (int i = 0; i < 100; ++i) {
        double middle = before + (after - before) * (outside / (outside - inside));
        if (i % 8 == 7 || !(middle > before && middle < after)) middle = before + 0.5 * (after - before);
        if (middle <= before || middle >= after) break;
        const double separation = encounterAt(a, b, middle).distance.separation;
        if (separation >= 0 && separation <= touch) return middle;
        const int now = separation > 0 ? 1 : -1;
        (now > 0 ? before : after) = middle;
        (now > 0 ? outside : inside) = separation;
        if (now == side) (now > 0 ? inside : outside) *= 0.5;
        side = now;
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
    const double scale = std::max(a.boundingRadius, b.boundingRadius), whole = to - from, shortest = whole * 1e-12;
    const double thick = 0.5 * (inradiusOf(*a.shape) + inradiusOf(*b.shape));
    double time = from;
    Encounter now = encounterAt(a, b, time);
    for (int i = 0; i < 1000; ++i) {
        const double separation = now.distance.separation, left = to - time;
        const bool touches = separation <= (i == 0 ? resting : touch);
        if (touches && now.closingSpeed > 0) return time;
        const bool turns = now.a.angularVelocity != 0 || now.b.angularVelocity != 0;
        if (touches && i == 0 && !turns) return std::nullopt;  // they part, and nothing brings them together again
        const ClosingBound approach = approachIn(a, b, now, left);
        const double safe = touches ? 0.0 : approach.safeTime(separation);
        const double through = thick > 0 ? approach.safeTime(thick) : whole;
        const double least = std::max(std::min(through, whole) * always, shortest);
        if ((touches ? least : safe) >= left) return std::nullopt;
        const bool newton = separation < near * scale && now.closingSpeed * safe > 0.01 * separation;
        const double step = newton ? std::max(separation / now.closingSpeed, shortest) : std::max(safe, least);
        const double next = std::min(time + step, to);
        const Encounter ahead = encounterAt(a, b, next);
        const double rest = ahead.distance.separation;
        if (rest < 0 && !touches) return bracketed(a, b, time, separation, next, rest);
        if (next >= to) return rest <= touch && now.closingSpeed > 0 ? std::optional<double>(to) : std::nullopt;
        time = next;
        now = ahead;
    }
    return time;
}

}  // namespace plumb
