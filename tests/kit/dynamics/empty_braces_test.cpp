// SPDX-License-Identifier: MIT
// Do empty braces in place of a definition mean the default one?
#include <plumb/movers/grid_mover.h>
#include <plumb/plumb.h>
#include <plumb/stepping/clock.h>

#include "catch.h"

using namespace plumb;

TEST_CASE("empty braces for the definition of a world, a map, a clock or a grid mover are the default one",
          "[dynamics][symptom]") {
    const World world({});
    CHECK(world.gravity() == WorldDef{}.gravity);
    CHECK(TileMap({}) == TileMap());
    FixedClock clock({}), usual;
    CHECK(clock.advance(0.05).due == usual.advance(0.05).due);
    CHECK(GridMover({}).cell() == GridMover().cell());
}

TEST_CASE("a definition in braces, with one member or none, still makes a world", "[dynamics][symptom]") {
    CHECK(World({.gravity = {0, -1}}).gravity() == Vec2(0, -1));
    CHECK(World{{.gravity = {0, -2}}}.gravity() == Vec2(0, -2));
    CHECK(World(WorldDef{}).gravity() == World().gravity());
    CHECK(World(World({.gravity = {1, 0}})).gravity() == Vec2(1, 0));
}
