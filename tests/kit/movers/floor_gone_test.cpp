// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/movers/platform_mover.h>
#include <plumb/shapes/tile_text.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr double dt = 1.0 / 60;

}  // namespace

TEST_CASE("who cannot drop through, half on stone, does not fall through the one-way tiles that it then walks on",
          "[movers]") {
    for (double x : {2.9, 3.0, 3.1}) {
        World world;
        addStatic(world, {0, 0}, tiles(tileMapOf({"..........", "###=======", "..........", "##########"})));
        PlatformMover mover(addKinematic(world, {x, 3.5}, box({0.3, 0.45})));
        const auto step = [&](const PlatformInput& input, int ticks) {
            for (int i = 0; i < ticks; ++i) {
                mover.step(world, input, dt);
                world.step(dt);
            }
        };
        step({}, 20);
        step({.jump = true, .down = true}, 1);
        step({}, 10);
        CHECK_FALSE(mover.slide().dropping);
        step({.move = 1}, 60);
        CHECK(mover.slide().isOnFloor);
        CHECK(mover.slide().position.x() > 4);
        CHECK(std::fabs(mover.slide().position.y() - 3.451) < 1e-9);
    }
}

}  // namespace plumb::test
