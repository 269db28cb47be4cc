// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>

#include <plumb/math/random.h>
#include <plumb/movers/move_and_slide.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/plumb.h>
#include <plumb/shapes/tile_text.h>
#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

ShapeDef randomShape(Random& random) {
    const double size = random.uniform(0.2, 1.2);
    switch (random.integer(0, 3)) {
        case 0: return circle(size);
        case 1: return plumb::box({size, size * random.uniform(0.4, 1.5)});
        case 2: return capsule({0, -size / 2}, {0, size / 2}, size / 2);
        default: return polygon({{-size, -size}, {size, -size}, {0.7 * size, size}, {-0.7 * size, size}});
    }
}

/// How far it lies below, or to the right of, the origin [m].
double reachOf(const ShapeDef& def, bool wall) {
    const Aabb box = aabbOf(def.shape, {});
    return wall ? box.upper.x() : -box.lower.y();
}

BodyDef groundOf(bool wall, bool tiled, double tile) {
    const int count = static_cast<int>(60 / tile);
    const double length = count * tile;
    BodyDef ground{.type = BodyType::Static};
    ground.position = wall ? Vec2(0, -length) : Vec2(0, -tile);
    if (tiled) {
        TileMap map({.columns = wall ? 1 : count, .rows = wall ? count : 1, .size = tile});
        for (int i = 0; i < count; ++i) map.set(wall ? Cell{0, i} : Cell{i, 0}, {.form = TileForm::Full});
        ground.shapes = {tiles(map)};
    } else {
        const Vec2 half = 0.5 * (wall ? Vec2(tile, length) : Vec2(length, tile));
        ground.shapes = {{.shape = boxPolygon(half, half)}};
    }
    return ground;
}

struct Run {
    ShapeDef shape;
    bool wall = false;
    double speed = 0, press = 0, tile = 1;
};

/// Where it comes to in two seconds, pressed against what it slides along.
Vec2 endOf(const Run& run, bool tiled) {
    World world({.gravity = {0, 0}});
    world.add(groundOf(run.wall, tiled, run.tile));
    const Vec2 way = run.wall ? Vec2(0, -1) : Vec2(1, 0), out = run.wall ? Vec2(-1, 0) : Vec2(0, 1);
    const BodyId body = world.add({.type = BodyType::Kinematic,
                                   .position = 2 * way + (reachOf(run.shape, run.wall) + 0.01) * out,
                                   .shapes = {run.shape}});
    Slide slide;
    for (int tick = 0; tick < 120; ++tick) {
        slide = moveAndSlide(world, body, {.velocity = run.speed * way - run.press * out, .dt = dt}, {}, slide);
        world.step(dt);
    }
    return world.body(body).position();
}

}  // namespace

TEST_CASE("10,000 movers slide over flush tiles, floor and wall, as on one slab, and lose nothing", "[movers][tiles]") {
    double apart = 0, lost = 0;
    const int runs = cases(10'000);
    for (int seed = 0; seed < runs; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Run run{.shape = randomShape(random), .wall = random.integer(0, 1) == 0};
        run.speed = random.uniform(1, 25);
        run.press = random.uniform(0.5, 12);
        run.tile = random.uniform(0.25, 1.5);
        const Vec2 tiled = endOf(run, true), whole = endOf(run, false);
        apart = std::max(apart, (tiled - whole).norm());
        const double went = run.wall ? -2 - tiled.y() : tiled.x() - 2;
        lost = std::max(lost, std::fabs(went - 2 * run.speed));
        INFO("seed " << seed << (run.wall ? " down a wall" : " on a floor") << " of tiles of " << run.tile << " m");
        CHECK((tiled - whole).norm() < 1e-9);
        // 120 times a velocity that is a way over dt, rounded to 2^-53 of some metres each.
        CHECK(std::fabs(went - 2 * run.speed) < 1e-9);
    }
    std::cout << "[tiles] " << runs << " movers: at most " << apart << " m from the run on a slab, " << lost
              << " m from speed times time\n";
}

TEST_CASE("a mover lands on a one-way tile from above, passes it from below, and is told the tiles it meets",
          "[movers][tiles]") {
    const TileMap map = tileMapOf({"....", ".==.", "....", "####"});
    World world;
    const BodyId ground = world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
    const BodyId hero =
        world.add({.type = BodyType::Kinematic, .position = {2, 1.5}, .shapes = {plumb::box({0.3, 0.45})}});
    Slide slide;
    double up = 9;
    bool passed = false;
    for (int tick = 0; tick < 180; ++tick) {
        up -= 9.81 * dt;
        slide = moveAndSlide(world, hero, {.velocity = {0, up}, .dt = dt}, {}, slide);
        if (slide.isOnFloor) up = 0;
        world.step(dt);
        passed = passed || world.body(hero).position().y() > 3.5;
        CHECK_FALSE(slide.isOnCeiling);
    }
    CHECK(passed);
    REQUIRE(slide.isOnFloor);
    CHECK(world.body(hero).position().y() == Approx(3.45).margin(2e-3));
    REQUIRE(slide.floor);
    CHECK(slide.floor->shape == world.body(ground).shapes().front());
    REQUIRE(slide.floor->tile);
    CHECK(map.at(*slide.floor->tile).kind == TileKind::OneWay);
}

TEST_CASE("a mover goes over hills of slope tiles at constant ground speed, and never leaves the ground",
          "[movers][tiles]") {
    const TileMap map = tileMapOf(
        {"......................", "....../#34............", "...12#####\\......../##", "######################"});
    World world;
    world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
    for (const ShapeDef& shape : {plumb::box({0.3, 0.45}), capsule({0, -0.2}, {0, 0.2}, 0.3)}) {
        const BodyId hero = world.add({.type = BodyType::Kinematic, .position = {1, 1.6}, .shapes = {shape}});
        PlatformMover mover(hero);
        for (int tick = 0; tick < 30; ++tick) {
            mover.step(world, {}, dt);
            world.step(dt);
        }
        REQUIRE(mover.slide().isOnFloor);
        int ticks = 0;
        for (; ticks < 600 && world.body(hero).position().x() < 21; ++ticks) {
            const Vec2 before = world.body(hero).position();
            mover.step(world, {.move = 1}, dt);
            world.step(dt);
            REQUIRE(mover.slide().isOnFloor);
            REQUIRE_FALSE(mover.slide().isOnWall);
            const double way = (world.body(hero).position() - before).norm();
            // In a tick that rounds a foot or a top the chord is shorter than the way along both sides: at 45 degrees
            // cos(22.5 degrees) of it at least.
            if (ticks > 15) CHECK(way / dt > 4 * std::cos(0.3927) - 0.05);
            if (ticks > 15) CHECK(way / dt < 4 + 0.05);
        }
        CHECK(world.body(hero).position().x() > 21);
        world.remove(hero);
    }
}

TEST_CASE("a mover that takes off and lands again in one tick stays where it landed", "[movers][tiles]") {
    // Against the ceiling, 9.9 cm up, along it and onto the slope at x = 7, all in one tick.
    World world;
    world.add({.type = BodyType::Static, .shapes = {tiles(tileMapOf({"##########", "......./##", "##########"}))}});
    const BodyId hero =
        world.add({.type = BodyType::Kinematic, .position = {5, 1.451}, .shapes = {plumb::box({0.4, 0.45})}});
    Slide slide;
    const auto tick = [&](const Vec2& velocity) {
        slide = moveAndSlide(world, hero, {.velocity = velocity, .dt = dt}, {}, slide);
        world.step(dt);
        return world.body(hero).position();
    };
    for (int i = 0; i < 3; ++i) tick({0, -0.1});
    const Vec2 landed = tick({150, 10});
    REQUIRE(slide.isOnFloor);
    CHECK(landed.x() > 6.4);
    CHECK(tick({0, 0}) == landed);
    CHECK(tick({0, 0}) == landed);
}
