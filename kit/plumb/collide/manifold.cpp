// SPDX-License-Identifier: MIT
#include <plumb/collide/manifold.h>

#include <plumb/collide/detail/circle_manifold.h>
#include <plumb/collide/detail/polygon_manifold.h>
#include <plumb/collide/detail/rounding.h>

namespace plumb {

namespace {

Vec2f turned(const RelativePose& pose, const Vec2f& v) {
    return {pose.cos * v.x() - pose.sin * v.y(), pose.sin * v.x() + pose.cos * v.y()};
}

Vec2f placed(const RelativePose& pose, const Vec2f& point) {
    const Vec2f direction = turned(pose, point);
    return direction + pose.position;
}

Convex placed(const RelativePose& pose, const Convex& shape) {
    Convex result;
    result.count = shape.count;
    result.radius = shape.radius;
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape.count); ++i) {
        result.vertices[i] = placed(pose, shape.vertices[i]);
        result.normals[i] = turned(pose, shape.normals[i]);
    }
    return result;
}

RelativePose inverse(const RelativePose& pose) {
    const RelativePose back{{0, 0}, pose.cos, -pose.sin};
    return {turned(back, -pose.position), back.cos, back.sin};
}

Disc discOf(const Convex& shape) {
    return {shape.vertices[0], shape.radius};
}

/// A's circle against B: B's against A, seen from A again. One point, whose feature is the same either way.
Manifold circleFirst(const Disc& a, const Convex& b, const RelativePose& bInA, float margin) {
    Manifold result = circleManifold(b, {placed(inverse(bInA), a.center), a.radius}, manhattan(bInA.position), margin);
    if (result.count == 0) return result;
    result.normal = turned(bInA, -result.normal);
    result.points[0].position = placed(bInA, result.points[0].position);
    return result;
}

}  // namespace

Manifold manifold(const Convex& a, const Convex& b, const RelativePose& bInA, float margin) {
    const float far = manhattan(bInA.position);
    if (a.count > 1 && b.count > 1) return polygonManifold(a, placed(bInA, b), far, margin);
    if (b.count > 1) return circleFirst(discOf(a), b, bInA, margin);
    const Disc disc{placed(bInA, b.vertices[0]), b.radius};
    return a.count > 1 ? circleManifold(a, disc, far, margin) : circleManifold(discOf(a), disc, margin);
}

}  // namespace plumb
