// SPDX-License-Identifier: MIT
#include <plumb/shapes/aabb.h>

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

}  // namespace

Aabb aabbOf(const Shape& shape, const Transform& pose) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        const Vec2 center = pose * circle->center;
        return inflate({center, center}, circle->radius);
    }
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return aroundPoints(polygon->vertices, pose);
    const auto& segment = std::get<Segment>(shape);
    const Vec2 ends[] = {segment.start, segment.end};
    return aroundPoints(ends, pose);
}

}  // namespace plumb
