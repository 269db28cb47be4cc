// SPDX-License-Identifier: MIT
#include <plumb/collide/convex.h>

#include <cmath>

namespace plumb {

namespace {

Convex emptyConvex() {
    Convex convex;
    convex.vertices.fill(Vec2f::Zero());
    convex.normals.fill(Vec2f::Zero());
    return convex;
}

/// Rounded to float last: a short edge far from the centre keeps its direction.
Convex convexAround(std::span<const Vec2> corners, const Vec2& center) {
    Convex convex = emptyConvex();
    convex.count = static_cast<int>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
        const Vec2 outward = -perp(edge) / std::sqrt(edge.dot(edge));
        convex.vertices[i] = Vec2(corners[i] - center).cast<float>();
        convex.normals[i] = outward.cast<float>();
    }
    return convex;
}

Convex convexOf(const Circle& circle, const Vec2& center) {
    Convex convex = emptyConvex();
    convex.count = 1;
    convex.vertices[0] = Vec2(circle.center - center).cast<float>();
    convex.radius = static_cast<float>(circle.radius);
    return convex;
}

Convex convexOf(const Polygon& polygon, const Vec2& center) {
    return convexAround(polygon.vertices, center);
}

Convex convexOf(const Segment& segment, const Vec2& center) {
    return convexAround(std::array{segment.start, segment.end}, center);
}

}  // namespace

Convex convexOf(const Shape& shape, const Vec2& center) {
    return std::visit([&](const auto& outline) { return convexOf(outline, center); }, shape);
}

}  // namespace plumb
