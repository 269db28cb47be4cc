// SPDX-License-Identifier: MIT
#include <compare/scene/random/worlds.h>

namespace plumb::compare {
namespace {

constexpr double thickness = 2;  // of walls [m]

}  // namespace

std::vector<ShapeDef> wallsAround(const Extent& extent, double bottom, double top, const Material& material) {
    const Vec2 wall(thickness / 2, (top - bottom) / 2 + thickness),
        lid((extent.right - extent.left) / 2, thickness / 2);
    const double middle = (bottom + top) / 2;
    const auto shape = [&](const Vec2& half, const Vec2& center) {
        return ShapeDef{.shape = boxPolygon(half, center), .material = material};
    };
    return {shape(wall, {extent.left - thickness / 2, middle}), shape(wall, {extent.right + thickness / 2, middle}),
            shape(lid, {(extent.left + extent.right) / 2, top + thickness / 2})};
}

ShapeDef floorAt(const Extent& extent, double y, const Material& material) {
    const Vec2 half((extent.right - extent.left) / 2 + thickness, thickness / 2);
    const Vec2 center((extent.left + extent.right) / 2, y - thickness / 2);
    return {.shape = boxPolygon(half, center), .material = material};
}

void setWorld(Scene& scene, std::vector<ShapeDef> shapes) {
    scene.bodies.front() = {worldName, {.type = BodyType::Static, .shapes = std::move(shapes)}};
}

std::vector<Vec2> placeOver(const std::vector<Item>& items, const Extent& extent, double bottom, Draw& draw,
                            double gap) {
    return placeInRows(items, rowsBetween(extent, bottom, gap), Draw(draw.seed())).value();
}

}  // namespace plumb::compare
