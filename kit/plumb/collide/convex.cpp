// SPDX-License-Identifier: MIT
#include <plumb/collide/convex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <plumb/math/check.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {

Vec2fArray::Vec2fArray(std::span<const Vec2f> vectors) {
    const std::size_t room = (vectors.size() + inlineCapacity - 1) / inlineCapacity * inlineCapacity;
    if (room > inlineCapacity) heap_.resize(2 * room);
    float* row = heap_.empty() ? inline_.data() : heap_.data();
    for (std::size_t i = 0; i < room; ++i) {
        const Vec2f& vector = vectors[std::min(i, vectors.size() - 1)];
        row[i] = vector.x();
        row[room + i] = vector.y();
    }
}

namespace {

Vec2f outwardOf(const Vec2& from, const Vec2& to) {
    const Vec2 edge = to - from;
    return Vec2(-perp(edge) / std::sqrt(edge.dot(edge))).cast<float>();
}

/// Rounded to float last: so a short edge far from the centre keeps its direction.
Convex convexAround(std::span<const Vec2> corners, double radius, const Vec2& center) {
    std::vector<Vec2f> vertices, normals;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        vertices.emplace_back(Vec2(corners[i] - center).cast<float>());
        normals.push_back(outwardOf(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]));
    }
    Convex convex;
    convex.vertices = Vec2fArray(vertices);
    convex.normals = Vec2fArray(normals);
    convex.count = static_cast<int>(corners.size());
    convex.radius = static_cast<float>(radius);
    return convex;
}

Convex convexOf(const Circle& circle, const Vec2& center) {
    const Vec2f middle = Vec2(circle.center - center).cast<float>();
    Convex convex;
    convex.vertices = Vec2fArray(std::span(&middle, 1));
    convex.count = 1;
    convex.radius = static_cast<float>(circle.radius);
    return convex;
}

Convex convexOf(const Capsule& capsule, const Vec2& center) {
    return convexAround(std::array{capsule.start, capsule.end}, capsule.radius, center);
}

Convex convexOf(const Polygon& polygon, const Vec2& center) {
    requireCount(polygon);
    return convexAround(polygon.vertices, polygon.radius, center);
}

Convex convexOf(const Segment& segment, const Vec2& center) {
    Convex convex = convexAround(std::array{segment.start, segment.end}, 0, center);
    if (segment.before) convex.before = outwardOf(*segment.before, segment.start);
    if (segment.after) convex.after = outwardOf(segment.end, *segment.after);
    return convex;
}

Convex convexOf(const Chain&, const Vec2&) {
    refuse("convexOf.shape", "a chain is not convex: its pieces are");
}

Convex convexOf(const TileMap&, const Vec2&) {
    refuse("convexOf.shape", "a tile map is not convex: its pieces are");
}

}  // namespace

Convex convexOf(const Shape& shape, const Vec2& center) {
    return std::visit([&](const auto& outline) { return convexOf(outline, center); }, shape);
}

}  // namespace plumb
