// SPDX-License-Identifier: MIT
// Does a world know how often it is drawn?
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include <plumb/stepping/clock.h>

#include <cstdint>
#include <iostream>
#include <set>
#include <vector>

#include "catch.h"

namespace {

using namespace plumb;

/// A tray in which seven bodies bounce off each other.
World tray() {
    World world({.gravity = {0, -9.81}});
    world.add({.type = BodyType::Static, .shapes = {chain({{-4, 6}, {-4, 0}, {4, 0}, {4, 6}})}});
    for (int i = 0; i < 7; ++i) {
        const Material bouncy{.friction = 0.4, .restitution = 0.7};
        const ShapeDef shape = i % 2 ? box({0.3, 0.2}, bouncy) : circle(0.25, bouncy);
        world.add({.position = {i - 3.0, 2 + 0.3 * i},
                   .velocity = {3.0 - i, 0},
                   .angularVelocity = 1.0 * i,
                   .shapes = {shape}});
    }
    return world;
}

constexpr int ticksWanted = 300;

/// The hash of the state after each of 300 ticks, when it is drawn as often as nextFrame() says.
template <typename NextFrame>
std::vector<std::uint64_t> hashesAt(const NextFrame& nextFrame) {
    World world = tray();
    FixedClock clock;
    std::vector<std::uint64_t> hashes;
    while (hashes.size() < ticksWanted) {
        for (int due = clock.advance(nextFrame()).due; due > 0 && hashes.size() < ticksWanted; --due) {
            world.step(clock.interval());
            hashes.push_back(stateHash(world));
        }
    }
    return hashes;
}

}  // namespace

TEST_CASE("300 ticks of bouncing bodies have the same state hashes at 24, 60, 144 and 240 Hz and at irregular frames",
          "[stepping][rates]") {
    const std::vector<std::uint64_t> once = hashesAt([] { return 1.0 / 60; });
    CHECK(std::set(once.begin(), once.end()).size() == ticksWanted);  // it moved all the time
    for (const double rate : {24.0, 144.0, 240.0}) CHECK(hashesAt([=] { return 1 / rate; }) == once);
    Random random(47);
    CHECK(hashesAt([&] { return random.uniform(0, 0.05); }) == once);
    CHECK(hashesAt([&] { return random.integer(0, 9) == 0 ? 2 : random.uniform(0, 0.02); }) == once);  // with stalls
}

TEST_CASE("stepped by the frame's own time, the same bodies end elsewhere at every display rate", "[stepping][rates]") {
    std::set<std::uint64_t> ends;
    for (const int rate : {24, 60, 144, 240}) {
        World world = tray();
        for (int frame = 0; frame < 5 * rate; ++frame) world.step(1.0 / rate);
        ends.insert(stateHash(world));
        std::cout << "stepping, variable step at " << rate << " Hz: the first body after 5 s at "
                  << world.body(world.bodies()[1]).position().transpose() << '\n';
    }
    CHECK(ends.size() == 4);
}
