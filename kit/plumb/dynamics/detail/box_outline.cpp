// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/box_outline.h>

#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

bool isBox(const Shape& shape) {
    const auto* polygon = std::get_if<Polygon>(&shape);
    if (polygon == nullptr || polygon->vertices.size() != 4 || polygon->radius != 0) return false;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 edge = polygon->vertices[(i + 1) % 4] - polygon->vertices[i];
        if (edge.x() != 0 && edge.y() != 0) return false;
    }
    return true;
}

}  // namespace

BoxOutline boxOutlineOf(const ShapeDef& shape, const Vec2& centerOfMass) {
    const Aabb box = aabbOf(shape.shape, {});
    const Vec2 half = 0.5 * (box.upper - box.lower);
    const Vec2 center = 0.5 * (box.upper + box.lower) - centerOfMass;
    BoxOutline outline;
    outline.exact = isBox(shape.shape);
    outline.restitution = static_cast<float>(shape.material.restitution);
    outline.halfX = static_cast<float>(half.x());
    outline.halfY = static_cast<float>(half.y());
    outline.centerX = static_cast<float>(center.x());
    outline.centerY = static_cast<float>(center.y());
    return outline;
}

}  // namespace plumb
