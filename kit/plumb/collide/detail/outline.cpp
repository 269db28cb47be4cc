// SPDX-License-Identifier: MIT
#include <plumb/collide/detail/outline.h>

#include <algorithm>

#include <plumb/math/detail/length.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {

namespace {

Outline outlineOf(const Circle& circle) {
    Outline outline;
    outline.corners[0] = circle.center;
    outline.count = 1;
    outline.radius = circle.radius;
    return outline;
}

Outline outlineOf(const Polygon& polygon) {
    requireCount(polygon);
    Outline outline;
    outline.radius = polygon.radius;
    outline.count = outline.edges = polygon.vertices.size();
    std::copy(polygon.vertices.begin(), polygon.vertices.end(), outline.corners.begin());
    for (std::size_t i = 0; i < outline.edges; ++i) outline.normals[i] = detail::unit(-perp(outline.edgeFrom(i)));
    return outline;
}

Outline outlineOf(const Vec2& start, const Vec2& end, double radius) {
    const Vec2 along = detail::unit(end - start);
    const Vec2 right = -perp(along);
    Outline outline;
    outline.radius = radius;
    outline.count = outline.edges = 4;
    std::copy_n(std::array{start, end, end, start}.begin(), 4, outline.corners.begin());
    std::copy_n(std::array<Vec2, 4>{right, along, -right, -along}.begin(), 4, outline.normals.begin());
    return outline;
}

Outline outlineOf(const Segment& segment) {
    return outlineOf(segment.start, segment.end, 0);
}

Outline outlineOf(const Capsule& capsule) {
    return outlineOf(capsule.start, capsule.end, capsule.radius);
}

/// Empty for a chain and a tile map: these are converted piece by piece.
Outline outlineOf(const Chain&) {
    return {};
}
Outline outlineOf(const TileMap&) {
    return {};
}

}  // namespace

Outline outlineOf(const Shape& shape, const Transform& pose, const Vec2& origin) {
    Outline outline = std::visit([](const auto& s) { return outlineOf(s); }, shape);
    place(outline, pose.rotation, pose.position - origin, outline);
    return outline;
}

void place(const Outline& outline, const Rot& rotation, const Vec2& shift, Outline& placed) {
    placed.count = outline.count;
    placed.edges = outline.edges;
    placed.radius = outline.radius;
    for (std::size_t i = 0; i < outline.count; ++i) placed.corners[i] = rotation * outline.corners[i] + shift;
    for (std::size_t i = 0; i < outline.edges; ++i) placed.normals[i] = rotation * outline.normals[i];
}

}  // namespace plumb
