// SPDX-License-Identifier: MIT
#include <plumb/shapes/bounding_circle.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <plumb/math/check.h>
#include <plumb/math/random.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {
namespace {

/// A point this far outside the circle, relative to its radius, counts as on it: rounding of the two or three points
/// that define it [-].
constexpr double onCircle = 1e-14;

bool holds(const BoundingCircle& circle, const Vec2& point) {
    return !((point - circle.center).norm() > circle.radius * (1 + onCircle));
}

BoundingCircle around(const Vec2& a, const Vec2& b) {
    return {0.5 * a + 0.5 * b, 0.5 * (b - a).norm()};
}

/// The circle through three points; for collinear points, the circle on the two that are farthest apart.
BoundingCircle through(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 ab = b - a, ac = c - a;
    const double twice = 2 * cross(ab, ac);
    const Vec2 fromA = (ab * ac.dot(ac) - ac * ab.dot(ab)) / twice;
    if (fromA.allFinite()) return {a + perp(fromA), fromA.norm()};
    const auto smaller = [](const BoundingCircle& p, const BoundingCircle& q) { return p.radius < q.radius; };
    return std::max({around(a, b), around(b, c), around(c, a)}, smaller);
}

std::vector<Vec2> shuffled(std::span<const Vec2> points) {
    std::vector<Vec2> order(points.begin(), points.end());
    Random random(1);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
    return order;
}

/// Each point outside of the smallest circle of those before it is on the smallest circle of them and itself (Welzl's
/// algorithm).
BoundingCircle smallestAround(std::span<const Vec2> points) {
    BoundingCircle circle{points[0], 0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (holds(circle, points[i])) continue;
        circle = {points[i], 0};
        for (std::size_t j = 0; j < i; ++j) {
            if (holds(circle, points[j])) continue;
            circle = around(points[i], points[j]);
            for (std::size_t k = 0; k < j; ++k)
                if (!holds(circle, points[k])) circle = through(points[i], points[j], points[k]);
        }
    }
    return circle;
}

BoundingCircle circleAround(std::span<const Vec2> points, double radius) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) requireFinite(points[i], "boundingCircleOf.points[" + std::to_string(i) + "]");
    if (points.empty()) refuse("boundingCircleOf.points", "there are none");
    std::vector<Vec2> fromFirst = shuffled(points);
    for (Vec2& point : fromFirst) point -= points.front();
    const BoundingCircle circle = smallestAround(fromFirst);
    double farthest = 0;
    for (const Vec2& point : fromFirst) farthest = std::max(farthest, (point - circle.center).norm());
    return {points.front() + circle.center, farthest + radius};
}

}  // namespace

BoundingCircle boundingCircleOf(const Shape& shape, const Transform& pose) {
    validate(shape, "boundingCircleOf.shape");
    CorePoints core = corePointsOf(shape);
    for (Vec2& point : core.points) point = pose * point;
    return circleAround(core.points, core.radius);
}

BoundingCircle boundingCircleOf(std::span<const Vec2> points) {
    return circleAround(points, 0);
}

bool overlap(const BoundingCircle& a, const BoundingCircle& b) {
    const Vec2 between = b.center - a.center;
    const double radii = a.radius + b.radius;
    return between.dot(between) <= radii * radii;
}

bool contains(const BoundingCircle& circle, const Vec2& point) {
    const Vec2 from = point - circle.center;
    return from.dot(from) <= circle.radius * circle.radius;
}

}  // namespace plumb
