// SPDX-License-Identifier: MIT
#include <plumb/shapes/aabb.h>

#include <plumb/shapes/detail/point_sets.h>
#include <array>
#include <span>

namespace plumb {
namespace {

Aabb aroundPoints(std::span<const Vec2> points, const Transform& pose) {
    const Vec2 first = pose * points.front();
    Aabb box{first, first};
    for (const Vec2& point : points.subspan(1)) {
        const Vec2 placed = pose * point;
        box = merge(box, {placed, placed});
    }
    return box;
}

Aabb boxOf(const Circle& circle, const Transform& pose) {
    const Vec2 center = pose * circle.center;
    return inflate({center, center}, circle.radius);
}

Aabb boxOf(const Capsule& capsule, const Transform& pose) {
    return inflate(aroundPoints(std::array{capsule.start, capsule.end}, pose), capsule.radius);
}

Aabb boxOf(const Polygon& polygon, const Transform& pose) {
    requireCount(polygon);
    return inflate(aroundPoints(polygon.vertices, pose), polygon.radius);
}

Aabb boxOf(const Segment& segment, const Transform& pose) {
    return aroundPoints(std::array{segment.start, segment.end}, pose);
}

Aabb boxOf(const Chain& chain, const Transform& pose) {
    requireCount(chain);
    return aroundPoints(chain.points, pose);
}

Aabb boxOf(const TileMap& map, const Transform& pose) {
    return aroundPoints(outerCornersOf(map), pose);
}

}  // namespace

Aabb aabbOf(const Shape& shape, const Transform& pose) {
    return std::visit([&](const auto& outline) { return boxOf(outline, pose); }, shape);
}

}  // namespace plumb
