// SPDX-License-Identifier: MIT
// How long does a platform mover take?
#include <plumb/movers/platform_mover.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

TEST_CASE("1,000 platform movers run and jump over hills, boxes and lifts", "[.][!benchmark][movers]") {
    World world;
    std::vector<Vec2> hills;
    for (int i = 1010; i >= -10; --i) hills.push_back({2.0 * i, i % 3 == 0 ? 0.8 : 0.0});
    addStatic(world, {0, 0}, chain(hills));
    std::vector<PlatformMover> movers;
    for (int i = 0; i < 1000; ++i) {
        if (i % 2 == 0) addStatic(world, {2.0 * i, 3}, box({0.6, 0.2}));
        if (i % 10 == 5) addKinematic(world, {2.0 * i, 2.5}, box({0.8, 0.1}), {0, 0.01});
        movers.emplace_back(addKinematic(world, {2.0 * i, 5}, box({0.3, 0.6})));
    }
    int tick = 0;
    const auto moveAll = [&] {
        ++tick;
        for (std::size_t i = 0; i < movers.size(); ++i) {
            const int beat = tick / 40 + static_cast<int>(i);
            movers[i].step(world, {.move = beat % 2 == 0 ? 1.0 : -1.0, .jump = beat % 5 == 0}, 1.0 / 60);
        }
    };
    const auto stepAll = [&] {
        moveAll();
        world.step(1.0 / 60);
    };
    for (int i = 0; i < 120; ++i) stepAll();
    BENCHMARK("a tick of 1,000 of them, and the world's step") {
        stepAll();
        return tick;
    };
    BENCHMARK("the world's step alone") {
        world.step(1.0 / 60);
        return tick;
    };
}

}  // namespace plumb::test
