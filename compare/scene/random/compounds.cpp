// SPDX-License-Identifier: MIT
#include <compare/scene/random/bodies.h>

namespace plumb::compare {
namespace {

/// A rectangle of a body that fits in a circle of radius 1.
struct Part {
    double left, right, bottom, top;
};

std::vector<ShapeDef> boxes(std::initializer_list<Part> parts, double radius, const Material& material) {
    std::vector<ShapeDef> shapes;
    for (const auto& [left, right, bottom, top] : parts) {
        const Vec2 half = radius / 2 * Vec2(right - left, top - bottom);
        const Vec2 center = radius / 2 * Vec2(right + left, top + bottom);
        shapes.push_back({.shape = boxPolygon(half, center), .material = material});
    }
    return shapes;
}

std::vector<ShapeDef> arrowHead(double radius, const Material& material) {
    const Vec2 left = radius * Vec2(-0.9, -0.3), right = radius * Vec2(0.9, -0.3);
    const Vec2 notch = radius * Vec2(0, -0.1), tip = radius * Vec2(0, 0.9);
    return {polygon({left, notch, tip}, material), polygon({notch, right, tip}, material)};
}

std::vector<ShapeDef> dumbBell(double radius, const Material& material) {
    const double end = 0.65 * radius;
    const auto ball = [&](double x) { return ShapeDef{.shape = Circle{0.35 * radius, {x, 0}}, .material = material}; };
    return {ball(-end), ball(end), box({end, 0.12 * radius}, material)};
}

}  // namespace

std::vector<ShapeDef> drawCompound(Draw& draw, double radius, const Material& material) {
    switch (draw.integer(0, 5)) {
        case 0: return boxes({{-0.6, -0.2, -0.6, 0.7}, {-0.2, 0.6, -0.6, -0.2}}, radius, material);  // L
        case 1: return boxes({{-0.8, 0.8, 0.2, 0.55}, {-0.18, 0.18, -0.9, 0.2}}, radius, material);  // T
        case 2:                                                                                      // cup
            return boxes({{-0.7, 0.7, -0.6, -0.3}, {-0.7, -0.4, -0.3, 0.6}, {0.4, 0.7, -0.3, 0.6}}, radius, material);
        case 3:  // cross
            return boxes({{-0.9, 0.9, -0.2, 0.2}, {-0.2, 0.2, 0.2, 0.9}, {-0.2, 0.2, -0.9, -0.2}}, radius, material);
        case 4: return arrowHead(radius, material);
        default: return dumbBell(radius, material);
    }
}

}  // namespace plumb::compare
