// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr double slideStep = 1.0 / 60;  // [s]
constexpr int slideTicks = 120;
constexpr int runs = 40;          // at each speed
constexpr double noticed = 0.01;  // a snag is a loss of more than this in one step [m/s]
constexpr Material smooth{.friction = 0};

std::vector<double> slideSpeeds() {
    return geometricSteps(1, 16, 9);
}

enum class Ground { Floor, Wall };

struct Slider {
    ShapeDef shape;
    double below = 0;  ///< distance from its centre to the surface that it slides on [m]
};

Slider randomSlider(Random& random) {
    const double size = random.uniform(0.2, 1.2), height = size * random.uniform(0.4, 1);
    switch (random.integer(0, 3)) {
        case 0: return {circle(size, smooth), size};
        case 1: return {box({size, height}, smooth), height};
        case 2: return {capsule({-size, 0}, {size, 0}, size / 2, smooth), size / 2};
        default: {
            // A hexagon on one of its sides.
            std::vector<Vec2> corners;
            for (int i = 0; i < 6; ++i) {
                const SinCos turned = sinCos(std::numbers::pi * i / 3);
                corners.emplace_back(size * turned.cos, size * turned.sin);
            }
            return {polygon(corners, smooth), size * std::sqrt(0.75)};
        }
    }
}

/// A smooth body is pressed onto smooth tiles: it slides along a floor, or falls down a wall.
Scene sliding(Ground ground, double speed, int number) {
    Random random(static_cast<std::uint64_t>(number));
    const Slider slider = randomSlider(random);
    const double tile = random.uniform(0.25, 1.5), press = random.uniform(2, 12);
    const bool wall = ground == Ground::Wall;
    const int count = static_cast<int>(70 / tile);
    TileMap map({.columns = wall ? 1 : count, .rows = wall ? count : 1, .size = tile});
    for (int i = 0; i < count; ++i) map.set(wall ? Cell{0, i} : Cell{i, 0}, {.form = TileForm::Full});
    const Vec2 along = wall ? Vec2(0, -1) : Vec2(1, 0), out = wall ? Vec2(-1, 0) : Vec2(0, 1);
    return {.name = "sliding",
            .gravity = -press * out + (wall ? 9.81 : 0.0) * along,
            .duration = slideTicks * slideStep,
            .dt = slideStep,
            .sleeping = false,
            .bodies = {{"ground",
                        {.type = BodyType::Static,
                         .position = wall ? Vec2(0, -count * tile) : Vec2(0, -tile),
                         .shapes = {tiles(map, smooth)}}},
                       {"slider",
                        {.position = random.uniform(2, 4) * along + slider.below * out,
                         .angle = wall ? std::numbers::pi / 2 : 0,
                         .velocity = speed * along,
                         .shapes = {slider.shape}}}}};
}

bool snags(const Engine& engine, const Scene& scene) {
    const Vec2 along = scene.bodies[1].def.velocity.normalized();
    const auto simulation = engine.build(scene);
    double before = scene.bodies[1].def.velocity.dot(along);
    for (int tick = 0; tick < slideTicks; ++tick) {
        simulation->step(slideStep);
        const double now = simulation->states()[1].velocity.dot(along);
        if (!(before - now <= noticed)) return true;
        before = now;
    }
    return false;
}

Curve curveOf(const Engine& engine, Ground ground) {
    Curve curve{.name = engine.name};
    double all = 0;
    for (const double speed : slideSpeeds()) {
        int caught = 0;
        for (int run = 0; run < runs; ++run) caught += snags(engine, sliding(ground, speed, run)) ? 1 : 0;
        curve.points.push_back({speed, 100.0 * caught / runs});
        all += caught;
    }
    curve.note = fmt::format("{:.0f} of {}", all, runs * slideSpeeds().size());
    return curve;
}

double caughtIn(const Curve& curve) {
    double sum = 0;
    for (const Point& point : curve.points) sum += std::round(point.y * runs / 100);
    return sum;
}

void runOn(Ground ground, const std::vector<Engine>& engines, LabRun& run) {
    const bool wall = ground == Ground::Wall;
    Graph graph{.title = wall ? "Down a wall of flush tiles" : "Along a floor of flush tiles",
                .x = {"speed at the start", "m/s", true},
                .y = {"runs that were caught", "%"}};
    std::string text = fmt::format("{}, {} runs without friction, caught:", graph.title, runs * slideSpeeds().size());
    for (const Engine& engine : engines) {
        graph.curves.push_back(curveOf(engine, ground));
        const double caught = caughtIn(graph.curves.back());
        run.values[engine.name + (wall ? ".caught.wall" : ".caught.floor")] = caught;
        text += fmt::format(" {:.0f} in {};", caught, engine.label);
    }
    text.back() = '.';
    run.graphs.push_back(graph);
    run.seen.push_back(text);
}

LabRun runFlushTiles(const std::vector<Engine>& engines) {
    LabRun run;
    if (engines.empty()) return run;
    runOn(Ground::Floor, engines, run);
    runOn(Ground::Wall, engines, run);
    return run;
}

}  // namespace

Lab flushTiles() {
    const std::string reason = "inner edges are removed: a body has nothing to catch on";
    return {.name = "flush_tiles",
            .question = "How often is something caught that slides over flush tiles without friction?",
            .varied = "the speed, from 1 to 16 m/s; discs, boxes, capsules and hexagons, and sizes of tiles, at random",
            .checks = {{.name = subjectName() + ".caught.floor", .reason = reason, .engine = subjectName()},
                       {.name = subjectName() + ".caught.wall", .reason = reason, .engine = subjectName()}},
            .run = runFlushTiles};
}

}  // namespace plumb::compare
