// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <plumb/plumb.h>
#include <plumb/shapes/tile_text.h>
#include "catch.h"
#include "kit/dynamics/sliders.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// The least speed to the right that a body keeps which slides over the end of a ground at x = 2, as a share of its
/// own.
double leastKept(const ShapeDef& ground, const Vec2& at, const ShapeDef& shape, double below, double speed) {
    World world;
    world.add({.type = BodyType::Static, .position = at, .shapes = {ground}});
    const BodyId body = world.add({.position = {0.6, below}, .velocity = {speed, 0}, .shapes = {shape}});
    double least = speed;
    for (int tick = 0; tick < 120 && world.body(body).position().y() > -1; ++tick) {
        world.step(1.0 / 60);
        least = std::min(least, world.body(body).velocity().x());
    }
    CHECK(world.body(body).position().x() > 2);
    return least / speed;
}

}  // namespace

TEST_CASE("discs, capsules and boxes go on over the brink of a tile map as of a slab, at 1 to 8 m/s",
          "[dynamics][tiles]") {
    struct Slider {
        const char* name;
        ShapeDef shape;
        double below;
    };
    const Slider sliders[] = {{"disc", circle(0.4, smooth), 0.4},
                              {"capsule", capsule({-0.3, 0}, {0.3, 0}, 0.2, smooth), 0.2},
                              {"box", box({0.4, 0.3}, smooth), 0.3}};
    for (const Slider& slider : sliders) {
        for (const double speed : {1.0, 2.0, 3.3, 4.0, 8.0}) {
            INFO(slider.name << " at " << speed << " m/s");
            // What turns over the brink trades speed forward for spin, on either ground alike.
            ShapeDef slab = box({1, 2.5}, smooth);
            const double whole = leastKept(slab, {1, -2.5}, slider.shape, slider.below, speed);
            const ShapeDef map = tiles(tileMapOf({"##..", "##..", "##.."}), smooth);
            CHECK(leastKept(map, {0, -3}, slider.shape, slider.below, speed) > whole - 0.02);
        }
    }
}
