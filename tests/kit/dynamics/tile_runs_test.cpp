// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr int runTicks = 120;

/// Something that slides or rolls without falling over: its friction is below half its width over its height.
struct RunSlider {
    ShapeDef shape;
    double below = 0;  ///< from its centre to what it rests on [m]
    const char* name = "";
};

ShapeDef shapeWithFriction(ShapeDef shape, double friction) {
    shape.material.friction = friction;
    return shape;
}

/// With an even number of sides and one of them below.
ShapeDef regularPolygon(int sides, double radius) {
    std::vector<Vec2> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / sides - std::numbers::pi / 2;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return polygon(corners);
}

RunSlider randomRunSlider(Random& random, double friction) {
    const double size = random.uniform(0.2, 1.2);
    switch (random.integer(0, 3)) {
        case 0: return {shapeWithFriction(circle(size), friction), size, "disc"};
        case 1: {
            const double height = size * random.uniform(0.4, 1.0);
            return {shapeWithFriction(box({size, height}), friction), height, "box"};
        }
        case 2: return {shapeWithFriction(capsule({-size, 0}, {size, 0}, size / 2), friction), size / 2, "capsule"};
        default: {
            const int sides = 2 * random.integer(2, 4);
            return {shapeWithFriction(regularPolygon(sides, size), friction), size * std::cos(std::numbers::pi / sides),
                    "polygon"};
        }
    }
}

/// One run along a floor or down a wall, on the left of it.
struct Run {
    RunSlider slider;
    bool wall = false;
    double speed = 0;     ///< along the way [m/s]
    double press = 9.81;  ///< toward what it slides on [m/s^2]
    double along = 0;     ///< acceleration on the way [m/s^2]
    double start = 0;     ///< on the way [m]
    double tile = 1;      ///< size of a tile [m]
    int tiles = 0;
    double friction = 0;

    Vec2 way() const { return wall ? Vec2(0, -1) : Vec2(1, 0); }
    Vec2 out() const { return wall ? Vec2(-1, 0) : Vec2(0, 1); }
};

Run randomRun(Random& random) {
    Run run;
    const bool smooth = random.integer(0, 1) == 0;
    run.friction = smooth ? 0 : random.uniform(0.05, 0.35);
    run.slider = randomRunSlider(random, run.friction);
    run.wall = random.integer(0, 1) == 0;
    run.speed = random.uniform(1, 12);
    run.press = random.uniform(2, 12);
    run.along = run.wall ? random.uniform(0, 3) : 0;
    run.start = random.uniform(2, 4);
    run.tile = random.uniform(0.25, 1.5);
    run.tiles = static_cast<int>(40 / run.tile);
    return run;
}

/// Its top, or its left side, through the origin.
BodyDef tiledGround(const Run& run) {
    const int deep = 2;
    const bool w = run.wall;
    TileMap map({.columns = w ? deep : run.tiles, .rows = w ? run.tiles : deep, .size = run.tile});
    for (int row = 0; row < map.rows(); ++row)
        for (int column = 0; column < map.columns(); ++column) map.set({column, row}, {.form = TileForm::Full});
    return {.type = BodyType::Static,
            .position = w ? Vec2(0, -run.tiles * run.tile) : Vec2(0, -deep * run.tile),
            .shapes = {shapeWithFriction(plumb::tiles(map), run.friction)}};
}

BodyDef slab(const Run& run) {
    const double length = run.tiles * run.tile / 2, deep = run.tile;
    const Vec2 half = run.wall ? Vec2(deep, length) : Vec2(length, deep);
    const Vec2 center = run.wall ? Vec2(deep, -length) : Vec2(length, -deep);
    return {.type = BodyType::Static, .position = center, .shapes = {shapeWithFriction(box(half), run.friction)}};
}

struct RunEnd {
    Vec2 position, velocity;
    double least = 0;  ///< of the speed on the way, over the run [m/s]
};

RunEnd endOf(const Run& run, const BodyDef& ground) {
    World world({.gravity = -run.press * run.out() + run.along * run.way(), .sleeping = false});
    world.add(ground);
    const BodyId body = world.add({.position = run.start * run.way() + run.slider.below * run.out(),
                                   .angle = run.wall ? std::numbers::pi / 2 : 0,
                                   .velocity = run.speed * run.way(),
                                   .shapes = {run.slider.shape}});
    double least = run.speed;
    for (int tick = 0; tick < runTicks; ++tick) {
        world.step(dt);
        least = std::min(least, world.body(body).velocity().dot(run.way()));
    }
    return {world.body(body).position(), world.body(body).velocity(), least};
}

}  // namespace

TEST_CASE("10,000 runs of discs, boxes, capsules and polygons over flush tiles are those on one slab",
          "[dynamics][tiles]") {
    double farthest = 0, slower = 0, lost = 0;
    const int runs = cases(10'000);
    for (int seed = 0; seed < runs; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Run run = randomRun(random);
        const RunEnd tiled = endOf(run, tiledGround(run)), whole = endOf(run, slab(run));
        const double away = (tiled.position - whole.position).norm();
        const double faster = (tiled.velocity - whole.velocity).norm() / run.speed;
        farthest = std::max(farthest, away);
        slower = std::max(slower, faster);
        INFO("seed " << seed << ": " << run.slider.name << (run.wall ? " down a wall" : " on a floor")
                     << " of tiles of " << run.tile << " m, friction " << run.friction);
        CHECK(away < 1e-3);
        CHECK(faster < 1e-3);
        if (run.friction > 0) continue;
        // Rounded to the solver's floats once, by half a unit in the last of 24 places; and never again.
        lost = std::max(lost, 1 - tiled.least / run.speed);
        CHECK(tiled.least >= run.speed * (1 - 0x1p-24));
    }
    std::cout << "[tiles] " << runs << " runs: at most " << farthest << " m and " << slower
              << " of the speed from the run on a slab; frictionless, " << lost << " of the speed lost\n";
}
