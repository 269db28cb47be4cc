// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/time_of_impact.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/collide/detail/outline.h>
#include <plumb/shapes/chain.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// Shapes nearer than this touch: about a thousand rounding errors of a length of 1 m [m].
constexpr double touch = 1e-12;
/// At the start, shapes nearer than this touch already: an impact in the step before may leave such a gap [m].
constexpr double resting = 1e-9;
/// The smallest step of the search, as a share of the time in which the two could move half-way through each other.
/// Without it, two shapes that touch and part, or that spin while they are very near, would need too many safe steps. A
/// touch that begins and ends within one such step is less deep than the same share of the shapes' thickness [-].
constexpr double always = 1e-2;
/// At separations below this share of the larger bounding radius, Newton's method is faster than safe steps [-].
constexpr double near = 1e-2;

Transform poseOf(const MovingShape& s, const BodyMotion& motion) {
    return {motion.center - motion.rotation * s.localCenter, motion.rotation};
}

/// A moving shape with what is the same at each time.
struct Mover {
    explicit Mover(const MovingShape& shape)
        : moving(shape),
          outline(outlineOf(*shape.shape, {}, shape.localCenter)),
          turningRadius(turningRadiusOf(*shape.shape, shape.localCenter)) {}

    BodyMotion at(double time) const { return moveFreely(moving.from, moving.law, time - moving.time); }

    const MovingShape& moving;
    Outline outline;  ///< from the centre of mass, not rotated
    double turningRadius;
};

/// Two shapes in free motion.
class MovingPair {
public:
    MovingPair(const MovingShape& a, const MovingShape& b)
        : a(a), b(b), inPieces_(hasPieces(*a.shape) || hasPieces(*b.shape)) {}

    Encounter at(double time) {
        Encounter e;
        e.a = a.at(time);
        e.b = b.at(time);
        e.distance = distanceAt(e.a, e.b);
        const Vec2 relative = velocityAt(e.b, e.distance.pointB) - velocityAt(e.a, e.distance.pointA);
        e.closingSpeed = -relative.dot(e.distance.normal);
        return e;
    }

    const Mover a, b;

private:
    Distance distanceAt(const BodyMotion& atA, const BodyMotion& atB) {
        if (inPieces_) return distance(*a.moving.shape, poseOf(a.moving, atA), *b.moving.shape, poseOf(b.moving, atB));
        place(a.outline, atA.rotation, {0, 0}, placedA_);
        place(b.outline, atB.rotation, atB.center - atA.center, placedB_);
        return distance(placedA_, placedB_, atA.center);
    }

    bool inPieces_;
    Outline placedA_, placedB_;
};

/// An upper bound on how far two shapes approach along a normal in a time t: speed * t + bend / 2 * t^2 [m].
struct ClosingBound {
    double speed = 0, bend = 0;  ///< [m/s, m/s^2]

    /// For this long, two shapes at this separation do not touch [s].
    double safeTime(double separation) const {
        const double fast = speed + std::sqrt(std::max(speed * speed + 2 * bend * separation, 0.0));
        return fast > 0 ? 2 * separation / fast : std::numeric_limits<double>::infinity();
    }
};

struct Pull {
    Vec2 linear{0, 0};
    double angular = 0;
};

Pull pullOn(const MovingShape& s, const BodyMotion& now) {
    return {s.law.acceleration.linear - now.velocity * s.law.linearDamping,
            s.law.acceleration.angular - now.angularVelocity * s.law.angularDamping};
}

/// The bound on the approach of b towards a, in the frame of a, which rotates. In that frame the spin of a large body a
/// counts only by the distance to b. The bound holds for the time left [s].
ClosingBound approachTo(const Mover& moverA, const Mover& moverB, const BodyMotion& nowA, const BodyMotion& nowB,
                        const Vec2& normal, double left) {
    const MovingShape &a = moverA.moving, &b = moverB.moving;
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
    return {closing + turn * moverB.turningRadius, pull + swing * farthest + spin * (2 * fastest + spin * farthest)};
}

/// The bound in the frame of the world, in which the outlines turn. It is the better one if both bodies spin.
ClosingBound approachOf(const Mover& a, const Mover& b, const Encounter& now, double left) {
    const Pull pullA = pullOn(a.moving, now.a), pullB = pullOn(b.moving, now.b);
    const auto outline = [left](const Mover& mover, const BodyMotion& motion, const Pull& pull) {
        return (std::fabs(motion.angularVelocity) + std::fabs(pull.angular) * left) * mover.turningRadius;
    };
    const double dampingA = a.moving.law.linearDamping, dampingB = b.moving.law.linearDamping;
    const double uneven = std::fabs(dampingB - dampingA) * pullA.linear.norm() * left;
    const Vec2 relative = now.b.velocity - now.a.velocity;
    return {outline(a, now.a, pullA) + outline(b, now.b, pullB) - relative.dot(now.distance.normal),
            (pullB.linear - pullA.linear).norm() + uneven};
}

/// Bounds in the frame of the larger body and in that of the world: the better one counts.
struct ClosingBounds {
    ClosingBounds(const MovingPair& pair, const Encounter& now, double left)
        : inLarger(pair.a.moving.boundingRadius >= pair.b.moving.boundingRadius
                       ? approachTo(pair.a, pair.b, now.a, now.b, now.distance.normal, left)
                       : approachTo(pair.b, pair.a, now.b, now.a, -now.distance.normal, left)),
          inWorld(approachOf(pair.a, pair.b, now, left)) {}

    /// For this long, the two do not come nearer by this distance [s].
    double safeTime(double distance) const { return std::max(inLarger.safeTime(distance), inWorld.safeTime(distance)); }

    ClosingBound inLarger, inWorld;
};

/// The time of the touch, from a time before it and a time after it. The result is exact to the touch tolerance, and
/// never after the touch.
/// Method: regula falsi. If the same end of the bracket stays twice, its weight is halved; in every eighth step, and if
/// a step would leave the bracket, bisection.
/// Source: Dowell and Jarratt, "A modified regula falsi method", 1971.
double bracketed(MovingPair& pair, double before, double separationBefore, double after, double separationAfter) {
    double outside = separationBefore, inside = separationAfter;
    int side = 0;
    for (int i = 0; i < 100; ++i) {
        double middle = before + (after - before) * (outside / (outside - inside));
        if (i % 8 == 7 || !(middle > before && middle < after)) middle = before + 0.5 * (after - before);
        if (middle <= before || middle >= after) break;
        const double separation = pair.at(middle).distance.separation;
        if (separation >= 0 && separation <= touch) return middle;
        const int now = separation > 0 ? 1 : -1;
        (now > 0 ? before : after) = middle;
        (now > 0 ? outside : inside) = separation;
        if (now == side) (now > 0 ? inside : outside) *= 0.5;
        side = now;
    }
    return before;
}

/// Two shapes touch and separate: may they meet again, because one turns or is pulled towards the other?
bool mayReturn(const MovingPair& pair, const Encounter& now) {
    if (now.a.angularVelocity != 0 || now.b.angularVelocity != 0) return true;
    const Pull pullA = pullOn(pair.a.moving, now.a), pullB = pullOn(pair.b.moving, now.b);
    return (pullB.linear - pullA.linear).dot(now.distance.normal) < 0 || pullA.angular != 0 || pullB.angular != 0;
}

/// Two discs that fall alike move in a straight line relative to each other: their time of impact is the root of a
/// quadratic equation, |d + v t| = r.
bool fallAlike(const MovingShape& a, const MovingShape& b) {
    return a.law.linearDamping == 0 && b.law.linearDamping == 0 &&
           a.law.acceleration.linear == b.law.acceleration.linear;
}

std::optional<double> timeOfImpactOfDiscs(const MovingShape& a, const MovingShape& b, double radius, double from,
                                          double to) {
    const double timeA = from - a.time, timeB = from - b.time;
    const Vec2& pull = a.law.acceleration.linear;
    const Vec2 startA = a.from.center + (a.from.velocity + pull * (0.5 * timeA)) * timeA;
    const Vec2 startB = b.from.center + (b.from.velocity + pull * (0.5 * timeB)) * timeB;
    const Vec2 d = startB - startA, v = (b.from.velocity - a.from.velocity) + pull * (timeB - timeA);
    const double closing = -d.dot(v);
    if (!(closing > 0)) return std::nullopt;
    const double gap = d.norm() - radius;
    if (gap <= resting) return from;
    const double outside = gap * (gap + 2 * radius), root = closing * closing - v.squaredNorm() * outside;
    if (root < 0) return std::nullopt;
    const double time = from + outside / (closing + std::sqrt(root));
    return time <= to ? std::optional(time) : std::nullopt;
}

/// A fast test: may the discs around both bodies touch in this time? Damping only makes a body slower, unless a force
/// or wind drives it, and that counts as acceleration.
bool mayMeet(const MovingShape& a, const MovingShape& b, double from, double to) {
    const double left = to - from;
    const BodyMotion nowA = moveFreely(a.from, a.law, from - a.time), nowB = moveFreely(b.from, b.law, from - b.time);
    const bool damped = a.law.linearDamping != 0 || b.law.linearDamping != 0;
    const Vec2 &pullA = a.law.acceleration.linear, &pullB = b.law.acceleration.linear;
    const double speed = damped ? nowA.velocity.norm() + nowB.velocity.norm() : (nowB.velocity - nowA.velocity).norm();
    const double pull = damped ? pullA.norm() + pullB.norm() : (pullB - pullA).norm();
    const double reach = a.boundingRadius + b.boundingRadius + (speed + 0.5 * pull * left) * left;
    return (nowB.center - nowA.center).squaredNorm() <= reach * reach * (1 + 1e-9);
}

}  // namespace

const Circle* discOf(const MovingShape& s) {
    const Circle* circle = std::get_if<Circle>(s.shape);
    return circle != nullptr && circle->center == s.localCenter ? circle : nullptr;
}

Encounter encounterAt(const MovingShape& a, const MovingShape& b, double time) {
    return MovingPair(a, b).at(time);
}

std::optional<double> timeOfImpact(const MovingShape& a, const MovingShape& b, double from, double to) {
    const Circle *discA = discOf(a), *discB = discOf(b);
    if (discA != nullptr && discB != nullptr && fallAlike(a, b))
        return timeOfImpactOfDiscs(a, b, discA->radius + discB->radius, from, to);
    if (!mayMeet(a, b, from, to)) return std::nullopt;
    MovingPair pair(a, b);
    const double scale = std::max(a.boundingRadius, b.boundingRadius), whole = to - from, shortest = whole * 1e-12;
    double time = from, thick = -1;
    Encounter now = pair.at(time);
    for (int i = 0; i < 1000; ++i) {
        const double separation = now.distance.separation, left = to - time;
        const bool touches = separation <= (i == 0 ? resting : touch);
        if (touches && now.closingSpeed > 0) return time;
        if (touches && i == 0 && !mayReturn(pair, now)) return std::nullopt;
        const ClosingBounds bounds(pair, now, left);
        const double safe = touches ? 0.0 : bounds.safeTime(separation);
        if (safe >= left) return std::nullopt;
        if (thick < 0) thick = 0.5 * (inradiusOf(*a.shape) + inradiusOf(*b.shape));
        const double through = thick > 0 ? bounds.safeTime(thick) : whole;
        const double least = std::max(std::min(through, whole) * always, shortest);
        if (touches && least >= left) return std::nullopt;
        const bool newton = separation < near * scale && now.closingSpeed * safe > 0.01 * separation;
        const double step = newton ? std::max(separation / now.closingSpeed, shortest) : std::max(safe, least);
        const double next = std::min(time + step, to);
        const Encounter ahead = pair.at(next);
        const double rest = ahead.distance.separation;
        if (rest < 0 && !touches) return bracketed(pair, time, separation, next, rest);
        if (next >= to) return rest <= touch && now.closingSpeed > 0 ? std::optional<double>(to) : std::nullopt;
        time = next;
        now = ahead;
    }
    return time;
}

}  // namespace plumb
