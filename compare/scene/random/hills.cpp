// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/worlds.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

struct Wave {
    double length, height, phase;  ///< [m, m, rad]
};

std::vector<Wave> drawWaves(Draw& draw) {
    std::vector<Wave> waves;
    for (int i = 0; i < 3; ++i) {
        const double length = draw.logUniform(4, 30), height = length * draw.uniform(0.01, 0.06);
        const double phase = draw.uniform(0, fullTurn);
        waves.push_back({length, height, phase});
    }
    return waves;
}

double heightAt(const std::vector<Wave>& waves, double x) {
    double height = 0;
    for (const Wave& wave : waves) height += wave.height * sinCos(fullTurn * x / wave.length + wave.phase).sin;
    return height;
}

/// From right to left, so that a chain that is solid from one side only is solid from above. It continues into the
/// walls.
std::vector<Vec2> lineOver(const std::vector<Wave>& waves, double half, double piece) {
    const int pieces = static_cast<int>(2 * (half + 1) / piece) + 1;
    std::vector<Vec2> points;
    for (int i = 0; i <= pieces; ++i) {
        const double x = (half + 1) * (1 - 2.0 * i / pieces);
        points.push_back({x, heightAt(waves, x)});
    }
    return points;
}

}  // namespace

std::string fillHills(Scene& scene, Draw& draw, const Filling& filling) {
    const double width = std::sqrt(areaOf(filling.items) * draw.logUniform(3, 12));
    const double half = std::max(width / 2, widestOf(filling.items) + 5);
    const std::vector<Wave> waves = drawWaves(draw);
    const double piece = std::max(draw.uniform(0.2, 1), half / 400);
    double highest = 0.05;
    for (const Wave& wave : waves) highest += wave.height;
    const std::vector<Vec2> origins = placeOver(filling.items, {-half, half}, highest, draw);
    const double top = addItems(scene, filling.items, origins);
    const Material ground{.friction = 0.7};
    std::vector<ShapeDef> shapes = wallsAround({-half, half}, -highest, top + headroom, ground);
    shapes.push_back(chain(lineOver(waves, half, piece), ground));
    setWorld(scene, shapes);
    return "on hills";
}

}  // namespace plumb::compare
