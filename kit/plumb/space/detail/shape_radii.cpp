// SPDX-License-Identifier: MIT
#include <plumb/space/detail/shape_radii.h>

#include <algorithm>
#include <limits>

namespace plumb {

namespace {

double inradiusOfOutline(const Circle& circle) {
    return circle.radius;
}

double inradiusOfOutline(const Capsule& capsule) {
    return capsule.radius;
}

double inradiusOfOutline(const Segment&) {
    return 0;
}

double inradiusOfOutline(const Chain&) {
    return 0;
}

double inradiusOfOutline(const TileMap&) {
    return 0;
}

/// The radius of the largest disc inside the rounded polygon whose centre is the mean of the corners.
double inradiusOfOutline(const Polygon& polygon) {
    Vec2 middle(0, 0);
    for (const Vec2& v : polygon.vertices) middle += v / static_cast<double>(polygon.vertices.size());
    double core = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec2 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - polygon.vertices[i];
        core = std::min(core, cross(edge, Vec2(middle - polygon.vertices[i])) / edge.norm());
    }
    return core + polygon.radius;
}

}  // namespace

double inradiusOf(const Shape& shape) {
    return std::visit([](const auto& outline) { return inradiusOfOutline(outline); }, shape);
}

double halfThicknessOf(std::span<const ShapeDef> shapes) {
    const auto isLine = [](const Shape& shape) {
        return std::holds_alternative<Segment>(shape) || std::holds_alternative<Chain>(shape) ||
               std::holds_alternative<TileMap>(shape);
    };
    double thickest = -1;
    for (const ShapeDef& def : shapes)
        if (!def.sensor && !isLine(def.shape)) thickest = std::max(thickest, inradiusOf(def.shape));
    return thickest < 0 ? std::numeric_limits<double>::infinity() : thickest;
}

double turningRadiusOf(const Shape& shape, const Vec2& center) {
    double reach = 0;
    const auto take = [&](const Vec2& point) { reach = std::max(reach, (point - center).norm()); };
    if (const auto* circle = std::get_if<Circle>(&shape)) take(circle->center);
    if (const auto* polygon = std::get_if<Polygon>(&shape))
        for (const Vec2& corner : polygon->vertices) take(corner);
    const auto takeEnds = [&](const auto* line) {
        if (line == nullptr) return;
        take(line->start);
        take(line->end);
    };
    takeEnds(std::get_if<Capsule>(&shape));
    takeEnds(std::get_if<Segment>(&shape));
    return reach;
}

}  // namespace plumb
