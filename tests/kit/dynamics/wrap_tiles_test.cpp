// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/plumb.h>
#include <plumb/shapes/tile_text.h>
#include "catch.h"

using namespace plumb;

namespace {

TileMap row(int columns) {
    TileMap map({.columns = columns, .rows = 1});
    for (int column = 0; column < columns; ++column) map.set({column, 0}, {.form = TileForm::Full});
    return map;
}

}  // namespace

TEST_CASE("a box, a disc and a capsule slide ten times round a world on a map as wide, and lose nothing",
          "[dynamics][tiles][wrap]") {
    for (const double left : {0.0, 7.3}) {
        for (const ShapeDef& shape : {box({0.4, 0.4}, {.friction = 0}), circle(0.4, {.friction = 0}),
                                      capsule({-0.4, 0}, {0.4, 0}, 0.4, {.friction = 0})}) {
            World world({.sleeping = false, .wrap = {.width = 20}});
            world.add({.type = BodyType::Static, .position = {left, -1}, .shapes = {tiles(row(20))}});
            const BodyId body = world.add({.position = {3, 0.4}, .velocity = {10, 0}, .shapes = {shape}});
            double least = 10, highest = 0;
            for (int tick = 0; tick < 1200; ++tick) {
                world.step(1.0 / 60);
                least = std::min(least, world.body(body).velocity().x());
                highest = std::max(highest, world.body(body).position().y());
            }
            CHECK(least >= 10 * (1 - 0x1p-24));
            CHECK(highest < 0.4 + 1e-4);
            CHECK(world.body(body).position().x() == Approx(3).margin(1e-3));
        }
    }
}

TEST_CASE("a disc goes round over a slope that lies across the seam as over one that does not",
          "[dynamics][tiles][wrap]") {
    const auto heightsAt = [&](double left) {
        World world({.sleeping = false, .wrap = {.width = 20}});
        TileMap hill({.columns = 20, .rows = 2});
        for (int column = 0; column < 20; ++column) hill.set({column, 0}, {.form = TileForm::Full});
        hill.set({18, 1}, {.form = TileForm::GentleUpLow});
        hill.set({19, 1}, {.form = TileForm::GentleUpHigh});
        hill.set({0, 1}, {.form = TileForm::GentleDownHigh});
        hill.set({1, 1}, {.form = TileForm::GentleDownLow});
        world.add({.type = BodyType::Static, .position = {left, 0}, .shapes = {tiles(hill)}});
        const BodyId body =
            world.add({.position = {left + 10, 1.4}, .velocity = {9, 0}, .shapes = {circle(0.4, {.friction = 0})}});
        std::vector<double> heights;
        for (int tick = 0; tick < 150; ++tick) {
            world.step(1.0 / 60);
            heights.push_back(world.body(body).position().y());
        }
        return heights;
    };
    const std::vector<double> across = heightsAt(0), within = heightsAt(10);
    CHECK(*std::max_element(across.begin(), across.end()) > 2);
    for (std::size_t i = 0; i < across.size(); ++i) REQUIRE(across[i] == Approx(within[i]).margin(1e-3));
}

TEST_CASE("a map that is not as wide as its world has ends there, though it was made to wrap",
          "[dynamics][tiles][wrap]") {
    for (const bool around : {false, true}) {
        World world(around ? WorldDef{.gravity = {0, 0}, .wrap = {.width = 20}} : WorldDef{.gravity = {0, 0}});
        world.add({.type = BodyType::Static, .position = {10, 0}, .shapes = {tiles(row(4).wrapping(true, true))}});
        const BodyId ball = world.add({.position = {8, 0.5}, .velocity = {3, 0}, .shapes = {circle(0.4)}});
        for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
        CHECK(world.body(ball).position().x() < 9.61);
        const auto hit = world.castShape(Circle{0.3}, {{8, 0.5}, {}}, {6, 0});
        REQUIRE(hit);
    }
}

TEST_CASE("a ray across the seam meets a tile in the map's first column, and names it", "[dynamics][tiles][wrap]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 20}});
    world.add({.type = BodyType::Static, .shapes = {tiles(tileMapOf({"#.................."}))}});
    const auto hit = world.castRay({17, 0.5}, {23, 0.5});
    REQUIRE(hit);
    CHECK(hit->point.x() == Approx(0).margin(1e-9));
    REQUIRE(hit->tile);
    CHECK(hit->tile->column == 0);
    const auto shape = world.castShape(Circle{0.25}, {{17, 0.5}, {}}, {6, 0});
    REQUIRE(shape);
    CHECK(shape->fraction * 6 == Approx(2.75).margin(1e-9));
    CHECK(shape->tile == hit->tile);
}
