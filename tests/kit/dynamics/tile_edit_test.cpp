// SPDX-License-Identifier: MIT
// What lies in line with a tile that changes?
#include <algorithm>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"

using namespace plumb;

namespace {

/// How far a stack on a row of tiles moves, at most, once the tile so many to its right is gone [m].
double movedBy(const ShapeDef& shape, int high, int away) {
    TileMap map({.columns = 48, .rows = 2});
    for (int i = 0; i < 48; ++i)
        for (int row = 0; row < 2; ++row) map.set({i, row}, {.form = TileForm::Full});
    World world;
    const BodyId ground = world.add({.type = BodyType::Static, .shapes = {tiles(map)}});
    std::vector<BodyId> stack;
    for (int i = 0; i < high; ++i) stack.push_back(world.add({.position = {18.5, 2.5 + i}, .shapes = {shape}}));
    const auto step = [&world] { world.step(1.0 / 60); };
    for (int tick = 0; tick < 600; ++tick) step();
    std::vector<Vec2> before;
    for (const BodyId& body : stack) before.push_back(world.body(body).position());
    world.setTile(world.body(ground).shapes()[0], {18 + away, 1}, {});
    double most = 0;
    for (int tick = 0; tick < 240; ++tick) {
        step();
        for (std::size_t i = 0; i < stack.size(); ++i)
            most = std::max(most, (world.body(stack[i]).position() - before[i]).norm());
    }
    return most;
}

}  // namespace

TEST_CASE("a body at rest does not move by 1e-6 m when a tile 2 to 20 from it is gone", "[dynamics][tiles]") {
    for (const ShapeDef& shape : {box({0.5, 0.5}), circle(0.5)})
        for (const int away : {2, 3, 8, 12, 15, 20}) {
            INFO("away " << away);
            CHECK(movedBy(shape, 1, away) < 1e-6);
        }
}

TEST_CASE("a stack of five boxes gives way by less than 0.5 mm when a tile in line with it is gone",
          "[dynamics][tiles]") {
    // The row is another piece then, whose contacts begin with what one box would press, not five: the lowest gives way
    // for some steps by as much as four boxes weigh, 4 * 5/8 g / (2 pi 60)^2 = 0.17 mm, and swings back.
    CHECK(movedBy(box({0.5, 0.5}), 5, 8) < 5e-4);
    CHECK(movedBy(box({0.5, 0.5}), 5, 20) < 1e-6);
}
