// SPDX-License-Identifier: MIT
// Is a mover told all the hazards that it touches, and no others?
#include <algorithm>
#include <cmath>

#include <plumb/collide/distance.h>
#include <plumb/math/random.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/shapes/tile_text.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

/// In a tick, of the modern profile: 20 m/s down or up, 4 aside, a step of 0.25 m up and as much down to a floor.
constexpr double farthest = 24 * dt + 0.25 + 0.35;

/// The columns of those in a row.
std::vector<int> columnsOf(const Slide& slide, int row) {
    std::vector<int> columns;
    for (const TileTouch& touch : slide.hazards)
        if (touch.tile.row == row) columns.push_back(touch.tile.column);
    std::ranges::sort(columns);
    return columns;
}

}  // namespace

TEST_CASE("who stands with one foot of 0.4 m on a hazard tile, the other on a solid one, is told the hazard",
          "[movers][tiles]") {
    for (const ShapeDef& hero : {box({0.4, 0.9}), roundedBox({0.3, 0.8}, 0.1)}) {
        for (const double at : {2.7, 3.0, 3.3, 3.5, 3.7, 4.0, 4.3}) {
            World world;
            const BodyId ground = addStatic(world, {0, 0}, tiles(tileMapOf({".......", "###^###"})));
            SlidingMover slider{addKinematic(world, {at, 1.95}, hero)};
            slider.land(world);
            for (int i = 0; i < 30; ++i) {
                slider.step(world, 0, dt);
                INFO("at " << at);
                REQUIRE(slider.slide.hazards.size() == 1);
                CHECK(slider.slide.hazards[0].tile == Cell{3, 0});
                CHECK(slider.slide.hazards[0].shape == ShapeId{ground, 0});
            }
        }
    }
}

TEST_CASE("hazards in line are told one by one, those of walls and ceilings too, and none that is 2 mm away",
          "[movers][tiles]") {
    World world;
    addStatic(world, {0, 0}, tiles(tileMapOf({"########", "#...^..#", "^.^...#^", "#......^", "##^^^^##"})));
    SlidingMover slider{addKinematic(world, {3.5, 1.46}, box({1.2, 0.45}))};
    slider.land(world);
    CHECK(columnsOf(slider.slide, 0) == std::vector{2, 3, 4});
    CHECK(slider.slide.hazards.size() == 3);
    for (int i = 0; i < 60; ++i) slider.step(world, 5, dt);
    // Its right side is at the wall of column 7, whose upper hazard lies behind a solid tile.
    CHECK(slider.slide.isOnWall);
    CHECK(columnsOf(slider.slide, 0) == std::vector{4, 5});
    CHECK(columnsOf(slider.slide, 1) == std::vector{7});
    CHECK(slider.slide.hazards.size() == 3);
    world.body(slider.body).setPose({5.798 - 0.002, 1.5}, 0);
    slider.step(world, 0, dt);
    CHECK(columnsOf(slider.slide, 1).empty());
    world.body(slider.body).setPose({3.2, 1.52}, 0);
    slider.slide = {};
    slider.slide.velocity.y() = 9;
    bool told = false;
    for (int i = 0; i < 30; ++i) told |= columnsOf(slider.step(world, 0, dt), 2) == std::vector{2};
    CHECK(told);
}

TEST_CASE("at 45 m/s, 0.75 m a tick, a mover of 0.2 m is told each hazard of 0.25 m that it runs over",
          "[movers][tiles]") {
    World world;
    addStatic(world, {0, 0},
              tiles(tileMapOf({"................................", "####^#^####^########^###^#######"}, 0.25)));
    SlidingMover slider{addKinematic(world, {0.3, 0.46}, box({0.1, 0.2}))};
    slider.land(world);
    std::vector<int> told;
    while (slider.slide.position.x() < 7)
        for (const int column : columnsOf(slider.step(world, 45, dt), 0)) told.push_back(column);
    told.erase(std::unique(told.begin(), told.end()), told.end());
    CHECK(told == std::vector{4, 6, 11, 20, 24});
}

TEST_CASE("in 200 random maps a mover is told each hazard that lies within a skin, none beyond 2 skins of its way",
          "[movers][tiles]") {
    Random random(11);
    const std::vector<ShapeDef> heroes{box({0.3, 0.6}), capsule({0, -0.3}, {0, 0.3}, 0.3), circle(0.4)};
    int touches = 0;
    for (int n = 0; n < cases(200); ++n) {
        TileMap map({.columns = 20, .rows = 12, .size = random.uniform(0.5, 1.5)});
        for (int i = 0; i < 100; ++i) {
            Tile tile{.form = static_cast<TileForm>(random.integer(1, 7))};
            if (random.integer(0, 1) == 0) tile.kind = TileKind::Hazard;
            tile.upsideDown = random.integer(0, 3) == 0;
            map.set({random.integer(0, 19), random.integer(0, 10)}, tile);
        }
        World world;
        const double turn = random.uniform(-0.3, 0.3);
        const BodyId ground = addStatic(world, {random.uniform(-5, 5), -3}, tiles(map), turn);
        const ShapeDef hero = heroes[static_cast<std::size_t>(n) % heroes.size()];
        const Transform pose = world.body(ground).pose();
        PlatformMover mover(addKinematic(world, pose * map.centerOf({10, 11}) + Vec2(0, 1), hero));
        PlatformInput input;
        for (int tick = 0; tick < 600; ++tick) {
            if (random.integer(0, 20) == 0) input.move = random.integer(-1, 1);
            if (random.integer(0, 10) == 0) input.jump = !input.jump;
            const Slide& slide = mover.step(world, input, dt);
            world.step(dt);
            const Transform now = world.body(mover.body()).pose();
            for (int i = 0; i < 20 * 12; ++i) {
                const Cell cell{i % 20, i / 20};
                if (map.at(cell).kind != TileKind::Hazard || isEmpty(map.at(cell))) continue;
                const double gap = distance(Polygon{map.cornersOf(cell)}, pose, hero.shape, now).separation;
                const bool told =
                    std::ranges::any_of(slide.hazards, [&](const TileTouch& t) { return t.tile == cell; });
                touches += told;
                INFO("map " << n << ", tick " << tick << ", cell " << cell.column << " " << cell.row << ", gap "
                            << gap);
                // Met where it begins, it is a rounding or two, or 1e-9 m of a cast's, farther than a skin.
                if (gap <= skin + 1e-8 && !told) FAIL("is not told");
                if (told && gap > 2 * skin + farthest) FAIL("is told");
            }
        }
    }
    CHECK(touches > 500 * cases(200) / 10);
}

}  // namespace plumb::test
