// SPDX-License-Identifier: MIT
#include <plumb/space/detail/box_outline.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

/// Does the line run along an axis of the body's frame?
bool isStraight(const Vec2& start, const Vec2& end) {
    return start.x() == end.x() || start.y() == end.y();
}

using Kind = BoxOutline::Kind;

Kind kindOf(const Circle&) {
    return Kind::Disc;
}
Kind kindOf(const Capsule& capsule) {
    return isStraight(capsule.start, capsule.end) ? Kind::Rounded : Kind::Other;
}
/// A segment of a chain is Other: its contacts depend on its neighbours, too.
Kind kindOf(const Segment& segment) {
    const bool alone = !segment.before && !segment.after;
    return alone && isStraight(segment.start, segment.end) ? Kind::Rounded : Kind::Other;
}
Kind kindOf(const Chain&) {
    return Kind::Other;
}
Kind kindOf(const TileMap&) {
    return Kind::Other;
}
Kind kindOf(const Polygon& polygon) {
    if (polygon.vertices.size() != 4) return Kind::Other;
    for (std::size_t i = 0; i < 4; ++i)
        if (!isStraight(polygon.vertices[i], polygon.vertices[(i + 1) % 4])) return Kind::Other;
    return polygon.radius > 0 ? Kind::Rounded : Kind::Box;
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
    outline.sensor = shape.sensor;
    outline.kind = std::visit([](const auto& s) { return kindOf(s); }, shape.shape);
    const bool disc = outline.kind == Kind::Disc;  // its computed half sizes are only rounding errors
    outline.halfX = disc ? 0.0f : static_cast<float>(half.x());
    outline.halfY = disc ? 0.0f : static_cast<float>(half.y());
    outline.radius = static_cast<float>(radius);
    outline.centerX = static_cast<float>(center.x());
    outline.centerY = static_cast<float>(center.y());
    outline.restitution = static_cast<float>(shape.material.restitution);
    return outline;
}

}  // namespace plumb
