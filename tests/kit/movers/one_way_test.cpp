// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/shapes/tile_text.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr PlatformInput dropThrough{.jump = true, .down = true};

ShapeDef oneWay(ShapeDef shape) {
    shape.oneWay = Vec2(0, 1);
    return shape;
}

/// Floors at heights 0 (not one-way), 1, 2, 3 and 4, from x = 0 to 40: all rows of one map, or slabs of 10 m.
void addFloors(World& world, bool asTiles) {
    if (asTiles) {
        const std::string row(40, '='), none(40, '.');
        addStatic(world, {0, -1}, tiles(tileMapOf({row, row, row, row, std::string(40, '#')})));
        return;
    }
    addStatic(world, {20, -0.5}, box({20, 0.5}));
    for (int height = 1; height <= 4; ++height)
        for (int i = 0; i < 4; ++i) addStatic(world, {10 * i + 5.0, height - 0.05}, oneWay(box({5, 0.05})));
}

struct OneWayGame {
    World world;
    PlatformMover mover{{}};

    void place(const Vec2& feet, const ShapeDef& hero = box({0.4, 0.9})) {
        mover = PlatformMover(addKinematic(world, feet + Vec2(0, 0.95), hero));
        for (int i = 0; i < 60 && !mover.slide().isOnFloor; ++i) step(still);
    }
    const Slide& step(const PlatformInput& input, double tick = dt) {
        mover.step(world, input, tick);
        world.step(tick);
        return mover.slide();
    }
    double feet() const { return mover.slide().position.y() - 0.9 - skin; }
};

}  // namespace

TEST_CASE("a mover of 1.8 m drops through one of four floors that lie 1 m above each other, and lands on the next",
          "[movers][tiles]") {
    for (const bool asTiles : {true, false}) {
        for (const ShapeDef& hero : {box({0.4, 0.9}), capsule({0, -0.5}, {0, 0.5}, 0.4)}) {
            OneWayGame game;
            addFloors(game.world, asTiles);
            game.place({5.3, 4}, hero);
            for (int floor = 4; floor > 0; --floor) {
                CHECK(std::fabs(game.feet() - floor) < 1e-9);
                game.step(dropThrough);
                CHECK_FALSE(game.mover.slide().isOnFloor);
                for (int i = 0; i < 60; ++i) game.step(still);
                REQUIRE(game.mover.slide().isOnFloor);
                CHECK(std::fabs(game.feet() - (floor - 1)) < 1e-9);
                CHECK(game.mover.slide().dropping.empty());
            }
        }
    }
}

TEST_CASE(
    "a mover that drops while it runs at 7 m/s is not caught by the next tile, slope or slab of what it drops from",
    "[movers][tiles]") {
    for (const double hz : {60.0, 240.0, 1000.0}) {
        for (int kind = 0; kind < 3; ++kind) {
            for (int start = 0; start < 40; ++start) {
                OneWayGame game;
                if (kind == 0) addFloors(game.world, true);
                if (kind == 1) addFloors(game.world, false);
                if (kind == 2) {
                    TileLegend legend = standardLegend();
                    for (auto& [letter, tile] : legend)
                        if (letter != '#') tile.kind = TileKind::OneWay;
                    const std::string none(40, '.'), hills = "===\\/=34..12=/\\34";
                    addStatic(game.world, {0, -3},
                              tiles(tileMapOf({hills + "==12==\\/==34==12======", none, none, none, none, none,
                                               std::string(40, '#')},
                                              1, legend)));
                }
                const double from = 1 + 0.5 * start + 0.013 * start;
                game.place({from, 4});
                const double before = game.feet();
                // At 1,000 Hz it runs over many tiles before it has sunk by a skin.
                const int ticks = static_cast<int>(hz / 4);
                for (int i = 0; i < ticks; ++i) game.step({.move = 1, .run = true}, 1 / hz);
                const bool stood = game.mover.slide().isOnFloor && game.mover.slide().floor->oneWay;
                if (!stood) continue;
                game.step({.move = 1, .run = true, .jump = true, .down = true}, 1 / hz);
                for (int i = 0; i < ticks / 4; ++i) {
                    game.step({.move = 1, .run = true}, 1 / hz);
                    INFO(hz << " Hz, kind " << kind << ", from " << from << ", tick " << i << ", feet " << game.feet());
                    REQUIRE_FALSE(game.mover.slide().isOnFloor);
                }
                CHECK(game.feet() < before + 1);
            }
        }
    }
}

TEST_CASE("a mover of 1.8 m that jumps up through a row, and is still in it, lands on the row 1 m below",
          "[movers][tiles]") {
    for (const double hz : {60.0, 120.0, 144.0}) {
        for (double speed = 3; speed < 9; speed += 0.1) {
            OneWayGame game;
            addFloors(game.world, true);
            game.place({5, 2});
            REQUIRE(std::fabs(game.feet() - 2) < 1e-9);
            game.mover.setVelocity({0, speed});
            double top = 2;
            for (int i = 0; i < 2 * hz; ++i) {
                game.step(still, 1 / hz);
                top = std::max(top, game.feet());
            }
            INFO(hz << " Hz, " << speed << " m/s up, feet at most at " << top);
            REQUIRE(game.mover.slide().isOnFloor);
            CHECK(std::fabs(game.feet() - std::floor(std::min(top, 4.0))) < 1e-9);
        }
    }
}

TEST_CASE("over peaks of one-way tiles and chains of 45 degrees a mover of 30 m/s goes on, and meets no wall",
          "[movers][tiles]") {
    Random random(3);
    for (int i = 0; i < cases(600); ++i) {
        World world;
        TileLegend legend = standardLegend();
        for (auto& [letter, tile] : legend) tile.kind = TileKind::OneWay;
        const Vec2 at(i % 3 == 0 ? 0 : random.uniform(-900, 900), i % 3 == 0 ? 0 : random.uniform(-90, 90));
        if (i % 2 == 0)
            addStatic(world, at, tiles(tileMapOf({".../\\../=\\./\\/\\...", "=================="}, 1, legend)));
        else
            addStatic(world, at,
                      chain({{18, 1},
                             {15, 1},
                             {14, 2},
                             {13, 1},
                             {12, 2},
                             {11, 1},
                             {10, 1},
                             {9, 2},
                             {8, 2},
                             {7, 1},
                             {5, 1},
                             {4, 2},
                             {3, 1},
                             {0, 1}}));
        PlatformProfile profile = modernProfile();
        profile.horizontal.walkSpeed = i < 2 ? 30 : random.uniform(5, 40);
        profile.horizontal.walkAcceleration = 1e4;
        const ShapeDef hero = i % 4 < 2 ? box({0.3, 0.45}) : roundedBox({0.2, 0.35}, 0.1);
        PlatformMover mover(addKinematic(world, at + Vec2(1, 1.6), hero), profile);
        const double tick = i < 2 ? 1.0 / 30 : random.uniform(0.004, 0.04);
        for (int k = 0; k < 60; ++k) {
            mover.step(world, {}, tick);
            world.step(tick);
        }
        while (mover.slide().position.x() < at.x() + 17) {
            mover.step(world, {.move = 1}, tick);
            world.step(tick);
            INFO("run " << i << " at " << (mover.slide().position - at).transpose() << ", tick " << tick);
            REQUIRE_FALSE(mover.slide().isOnWall);
            REQUIRE(mover.slide().position.y() > at.y());
        }
    }
}

}  // namespace plumb::test
