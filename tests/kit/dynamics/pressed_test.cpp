// SPDX-License-Identifier: MIT
// What holds where loads are far larger than the weight of what carries them?
#include <algorithm>
#include <cmath>
#include <random>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
using namespace plumb::test;

TEST_CASE("a box pressed by 100 to 100,000 times its weight rests", "[dynamics][contacts]") {
    for (const int subSteps : {2, 4, 8})
        for (const double rate : {60.0, 240.0})
            for (const double times : {1e2, 1e3, 3e3, 1e4, 3e4, 1e5}) {
                CAPTURE(subSteps, rate, times);
                World world({.gravity = {0, -9.81 * times}, .sleeping = false, .solver = {.subSteps = subSteps}});
                world.add({.type = BodyType::Static, .position = {0, -5}, .shapes = {box({20, 5})}});
                const BodyId pressed = world.add({.position = {0, 2}, .shapes = {box({2, 2})}});
                for (int tick = 0; tick < rate; ++tick) world.step(1 / rate);
                CHECK(world.body(pressed).position().y() > 1);
                CHECK(std::fabs(world.body(pressed).velocity().y()) < 1e-2);
            }
}
