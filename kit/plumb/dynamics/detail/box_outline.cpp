// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/box_outline.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

/// Does the line run along an axis of the body's frame?
bool isStraight(const Vec2& start, const Vec2& end) {
    return start.x() == end.x() || start.y() == end.y();
}

bool isUpright(const Circle&) {
    return true;
}
bool isUpright(const Capsule& capsule) {
    return isStraight(capsule.start, capsule.end);
}
bool isUpright(const Segment& segment) {
    return isStraight(segment.start, segment.end);
}
bool isUpright(const Chain&) {
    return false;
}
bool isUpright(const Polygon& polygon) {
    if (polygon.vertices.size() != 4) return false;
    for (std::size_t i = 0; i < 4; ++i)
        if (!isStraight(polygon.vertices[i], polygon.vertices[(i + 1) % 4])) return false;
    return true;
}

double radiusOf(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return circle->radius;
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
    const auto* polygon = std::get_if<Polygon>(&shape);
    return polygon != nullptr ? polygon->radius : 0;
}

}  // namespace

BoxOutline boxOutlineOf(const ShapeDef& shape, const Vec2& centerOfMass) {
    const Aabb box = aabbOf(shape.shape, {});
    const double radius = radiusOf(shape.shape);
    const Vec2 half = 0.5 * (box.upper - box.lower) - Vec2(radius, radius);
    const Vec2 center = 0.5 * (box.upper + box.lower) - centerOfMass;
    BoxOutline outline;
    outline.upright = std::visit([](const auto& s) { return isUpright(s); }, shape.shape);
    outline.exact = outline.upright && std::holds_alternative<Polygon>(shape.shape) && radius == 0;
    outline.halfX = static_cast<float>(half.x());
    outline.halfY = static_cast<float>(half.y());
    outline.radius = static_cast<float>(radius);
    outline.centerX = static_cast<float>(center.x());
    outline.centerY = static_cast<float>(center.y());
    outline.restitution = static_cast<float>(shape.material.restitution);
    return outline;
}

}  // namespace plumb
