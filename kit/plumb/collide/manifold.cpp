// SPDX-License-Identifier: MIT
#include <plumb/collide/manifold.h>

#include <plumb/collide/detail/chain_manifold.h>
#include <plumb/collide/detail/core.h>
#include <plumb/collide/detail/core_manifold.h>

namespace plumb {

namespace {

Vec2f turned(const RelativePose& pose, const Vec2f& v) {
    return {pose.cos * v.x() - pose.sin * v.y(), pose.sin * v.x() + pose.cos * v.y()};
}

Vec2f placed(const RelativePose& pose, const Vec2f& point) {
    const Vec2f direction = turned(pose, point);
    return direction + pose.position;
}

Core placed(const RelativePose& pose, const Convex& shape, PlacedRows& buffer) {
    const Core core = coreOf(shape);
    for (std::size_t i = 0; i < core.count; i += lanes) {
        const FourFloats x = lanesAt(core.x + i), y = lanesAt(core.y + i);
        store(pose.cos * x - pose.sin * y + pose.position.x(), buffer.x + i);
        store(pose.sin * x + pose.cos * y + pose.position.y(), buffer.y + i);
        const FourFloats nx = lanesAt(core.normalX + i), ny = lanesAt(core.normalY + i);
        store(pose.cos * nx - pose.sin * ny, buffer.normalX + i);
        store(pose.sin * nx + pose.cos * ny, buffer.normalY + i);
    }
    return {buffer.x, buffer.y, buffer.normalX, buffer.normalY, core.count, core.radius};
}

RelativePose inverse(const RelativePose& pose) {
    const RelativePose back{{0, 0}, pose.cos, -pose.sin};
    return {turned(back, -pose.position), back.cos, back.sin};
}

CoreDisc discOf(const Core& shape) {
    return {shape.vertex(0), shape.radius};
}

/// Only B may be a circle here.
Manifold placedManifold(const Convex& a, const Core& b, float magnitude, float margin) {
    if (isChainSegment(a)) return chainManifold(a, b, magnitude, margin);
    if (b.count > 1) return polygonManifold(coreOf(a), b, magnitude, margin);
    return circleManifold(coreOf(a), discOf(b), magnitude, margin);
}

/// B against A, with the result in A's frame.
Manifold exchanged(const Convex& a, const Convex& b, const RelativePose& bInA, float magnitude, float margin) {
    PlacedRows buffer;
    Manifold result = placedManifold(b, placed(inverse(bInA), a, buffer), magnitude, margin);
    if (result.count == 0) return result;
    result.normal = turned(bInA, -result.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(result.count); ++i) {
        ManifoldPoint& point = result.points[i];
        point.position = placed(bInA, point.position);
        point.feature = swapped(point.feature);
    }
    return result;
}

}  // namespace

Manifold manifold(const Convex& a, const Convex& b, const RelativePose& bInA, float margin) {
    if (a.count == 1 && b.count == 1)
        return circleManifold(discOf(coreOf(a)), {placed(bInA, b.vertices[0]), b.radius}, margin);
    const float magnitude = manhattan(bInA.position);
    // The circle, or the shape that is not a chain segment, is always B: so each case is written once.
    if (a.count == 1 || (isChainSegment(b) && !isChainSegment(a))) return exchanged(a, b, bInA, magnitude, margin);
    PlacedRows buffer;
    return placedManifold(a, placed(bInA, b, buffer), magnitude, margin);
}

}  // namespace plumb
