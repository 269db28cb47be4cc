// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/worlds.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

/// Walls around a circle of this radius. Each is as wide as its neighbours allow.
std::vector<ShapeDef> ringOfWalls(double radius, double thickness, int count, const Material& material) {
    const SinCos halfTurn = sinCos(fullTurn / (2 * count));
    const double inner = radius / halfTurn.cos, outer = (radius + thickness) / halfTurn.cos;
    std::vector<ShapeDef> walls;
    for (int i = 0; i < count; ++i) {
        const SinCos from = sinCos(fullTurn * i / count), to = sinCos(fullTurn * (i + 1) / count);
        const Vec2 first(from.cos, from.sin), second(to.cos, to.sin);
        walls.push_back(polygon({inner * first, outer * first, outer * second, inner * second}, material));
    }
    return walls;
}

Rows rowsInCircle(double radius) {
    const auto extent = [radius](double low, double high) -> std::optional<Extent> {
        const double farthest = std::max(std::abs(low), std::abs(high)), room = radius * radius - farthest * farthest;
        if (room <= 0) return {};
        return Extent{-std::sqrt(room), std::sqrt(room)};
    };
    return {.bottom = -radius, .top = radius, .gap = 0.05, .extent = extent};
}

}  // namespace

std::string fillDrum(Scene& scene, Draw& draw, const Filling& filling) {
    const double filled = draw.uniform(0.3, 0.6);
    const std::uint64_t seed = draw.seed();
    double radius = std::max(2.0, std::sqrt(areaOf(filling.items) / (fullTurn / 2 * filled)));
    std::optional<std::vector<Vec2>> origins;
    for (; !origins; radius *= 1.05) origins = placeInRows(filling.items, rowsInCircle(radius), Draw(seed));
    addItems(scene, filling.items, *origins);
    const double fastest = 5 / radius, turn = std::clamp(draw.eitherWay(0.2, 1.2), -fastest, fastest);
    const int walls = draw.integer(12, 40);
    scene.bodies.front() = {worldName, {.type = BodyType::Kinematic, .angularVelocity = turn}};
    scene.bodies.front().def.shapes = ringOfWalls(radius, 1 + 0.05 * radius, walls, {.friction = 0.8});
    return "in a drum that turns";
}

}  // namespace plumb::compare
