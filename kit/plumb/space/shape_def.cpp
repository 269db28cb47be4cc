// SPDX-License-Identifier: MIT
#include <plumb/space/shape_def.h>

#include <utility>

#include <plumb/shapes/decompose.h>

namespace plumb {

ShapeDef circle(double radius, const Material& material) {
    return {.shape = Circle{.radius = radius}, .material = material};
}

ShapeDef capsule(const Vec2& start, const Vec2& end, double radius, const Material& material) {
    return {.shape = Capsule{start, end, radius}, .material = material};
}

ShapeDef box(const Vec2& halfSize, const Material& material) {
    return {.shape = boxPolygon(halfSize), .material = material};
}

ShapeDef roundedBox(const Vec2& halfSize, double radius, const Material& material) {
    Polygon rounded = boxPolygon(halfSize);
    rounded.radius = radius;
    return {.shape = std::move(rounded), .material = material};
}

ShapeDef polygon(std::vector<Vec2> vertices, const Material& material) {
    return {.shape = Polygon{std::move(vertices)}, .material = material};
}

ShapeDef roundedPolygon(std::vector<Vec2> vertices, double radius, const Material& material) {
    return {.shape = Polygon{std::move(vertices), radius}, .material = material};
}

ShapeDef segment(const Vec2& start, const Vec2& end, const Material& material) {
    return {.shape = Segment{start, end}, .material = material};
}

ShapeDef chain(std::vector<Vec2> points, const Material& material) {
    return {.shape = Chain{std::move(points), false}, .material = material};
}

ShapeDef loop(std::vector<Vec2> points, const Material& material) {
    return {.shape = Chain{std::move(points), true}, .material = material};
}

ShapeDef tiles(TileMap map, const Material& material) {
    return {.shape = std::move(map), .material = material};
}

std::vector<ShapeDef> outline(std::vector<Vec2> points, const Material& material) {
    std::vector<ShapeDef> shapes;
    for (Polygon& piece : convexPieces(points)) shapes.push_back({.shape = std::move(piece), .material = material});
    return shapes;
}

}  // namespace plumb
