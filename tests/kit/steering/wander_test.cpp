// SPDX-License-Identifier: MIT
#include <plumb/steering/wander.h>

#include <algorithm>
#include <iostream>
#include <limits>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

struct Stroll {
    Agent agent{};
    double slowest = std::numeric_limits<double>::infinity();  ///< after the first second [m/s]
    double turned = 0;                                         ///< in all, to either side [rad]
};

Stroll strolled(std::uint64_t seed, double seconds, double step, const WanderSettings& settings = {}) {
    Stroll stroll;
    WanderState state{.random = Random(seed)};
    const int steps = static_cast<int>(std::lround(seconds / step));
    for (int i = 0; i < steps; ++i) {
        const WanderStep next = wander(stroll.agent, state, step, settings);
        state = next.state;
        const Vec2 before = headingOf(stroll.agent);
        stroll.agent = moved(stroll.agent, next.acceleration, step);
        if (i * step < 1) continue;
        stroll.slowest = std::min(stroll.slowest, stroll.agent.velocity.norm());
        stroll.turned += std::fabs(cross(before, headingOf(stroll.agent)));
    }
    return stroll;
}

}  // namespace

TEST_CASE("who wanders keeps to 85 % of the speed or more, and goes the same way for the same seed", "[steering]") {
    double slowest = 1;
    int alike = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Stroll first = strolled(seed, 60, dt), second = strolled(seed, 60, dt);
        CHECK(first.agent.position == second.agent.position);
        CHECK(first.agent.velocity == second.agent.velocity);
        alike += strolled(seed + 1, 60, dt).agent.position == first.agent.position;
        slowest = std::min(slowest, first.slowest / first.agent.maxSpeed);
        CHECK(first.turned > 2 * M_PI);  // it does not go straight on
    }
    std::cout << "steering: who wanders keeps to " << slowest << " of the speed\n";
    CHECK(alike == 0);
    CHECK(slowest > 0.85);
}

TEST_CASE("who wanders strays alike at 30 and at 240 Hz", "[steering]") {
    // The mean square of how far 300 come in 20 s, whose own spread is some 6 %.
    const auto meanSquare = [](double step) {
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 300; ++seed) sum += strolled(seed, 20, step).agent.position.squaredNorm();
        return sum / 300;
    };
    const double coarse = meanSquare(1.0 / 30), fine = meanSquare(1.0 / 240);
    std::cout << "steering: who wanders strays by " << std::sqrt(coarse) << " m in 20 s at 30 Hz, by "
              << std::sqrt(fine) << " m at 240 Hz\n";
    CHECK(std::fabs(coarse / fine - 1) < 0.25);
    CHECK(meanSquare(1.0 / 30) < 0.9 * 60 * 60);  // not as far as straight on
}

TEST_CASE("without jitter who wanders goes straight on", "[steering]") {
    const Stroll stroll = strolled(1, 10, dt, {.jitter = 0});
    CHECK(stroll.agent.position.y() == 0);
    CHECK(stroll.turned == 0);
}

TEST_CASE("settings that no stroll has are refused by name", "[steering][errors]") {
    const WanderState state{.random = Random(1)};
    CHECK_THROWS_WITH(wander({}, state, dt, {.radius = 0}), "WanderSettings.radius: 0 is not positive");
    CHECK_THROWS_WITH(wander({}, state, dt, {.ahead = 1, .radius = 2}),
                      "WanderSettings.ahead: 1 is not more than the radius");
    CHECK_THROWS_WITH(wander({}, state, dt, {.jitter = -1}), "WanderSettings.jitter: -1 is negative");
    CHECK_THROWS_WITH(wander({}, state, -1), "wander: dt: -1 is negative");
    CHECK_THROWS_WITH(wander({}, {.random = Random(1), .angle = std::nan("")}, dt),
                      "WanderState.angle: nan is not finite");
}
