// SPDX-License-Identifier: MIT
#include <plumb/steering/blend.h>

#include <array>
#include <iostream>
#include <vector>

#include <plumb/steering/avoid.h>
#include <plumb/steering/flock.h>
#include <plumb/steering/path.h>
#include <plumb/steering/pursue.h>
#include <plumb/steering/seek.h>
#include <plumb/steering/wander.h>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

/// Often at one of few places, so that many coincide.
Vec2 randomPlace(Random& random) {
    switch (random.integer(0, 4)) {
        case 0: return {0, 0};
        case 1: return {1, 1};
        case 2: return randomVec2(random, 1e-160);
        case 3: return randomVec2(random, 1e6);
        default: return randomVec2(random, 5);
    }
}

Agent anyAgent(Random& random) {
    Agent agent = randomAgent(random);
    agent.position = randomPlace(random);
    if (random.integer(0, 3) == 0) agent.velocity = {0, 0};
    if (random.integer(0, 9) == 0) agent.maxAcceleration = std::exp(random.uniform(-20, 20));
    return agent;
}

std::vector<Vec2> allBehaviours(Random& random, const Agent& agent) {
    const Vec2 there = randomPlace(random);
    const AgentState other{there, random.integer(0, 2) == 0 ? Vec2(0, 0) : randomVec2(random, 10)};
    const std::vector<AgentState> others{other, {agent.position, agent.velocity}, {randomPlace(random), {0, 1}}};
    const std::vector<RoundObstacle> trees{{randomPlace(random), random.uniform(0, 3)}, {there, 1}};
    const std::vector<WallSegment> walls{{randomPlace(random), there}, {there, there}};
    const std::vector<Vec2> points{{0, 0}, {1, 1}, {1, 1}, randomVec2(random, 5)};
    const Path path{.points = points, .closed = random.integer(0, 1) == 0};
    return {seek(agent, there),
            flee(agent, there),
            arrive(agent, there),
            pursue(agent, other),
            evade(agent, other),
            wander(agent, {.random = random}, random.uniform(0, 1)).acceleration,
            followPath(agent, path, random.uniform(0, 20), random.uniform(0.1, 5)).acceleration,
            avoidObstacles(agent, trees),
            avoidWalls(agent, walls),
            separate(agent, others),
            align(agent, others, {.view = random.uniform(0, 3)}),
            cohere(agent, others)};
}

}  // namespace

TEST_CASE("no behaviour asks for more than the agent has, or for what is no number, 100,000 times", "[steering]") {
    Random random(98);
    double worst = 0;
    int strange = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const Agent agent = anyAgent(random);
        for (const Vec2& asked : allBehaviours(random, agent)) {
            strange += !asked.allFinite();
            worst = std::max(worst, asked.norm() / agent.maxAcceleration);
        }
    }
    std::cout << "steering: behaviours ask for at most 1 + " << worst - 1 << " of what there is\n";
    CHECK(strange == 0);
    CHECK(worst < 1 + 6 * 1.1e-16);  // of what is limited, and of its norm here, some six roundings
}

TEST_CASE("blends keep to the budget, 100,000 times", "[steering]") {
    Random random(99);
    double worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const Agent agent = anyAgent(random);
        std::vector<WeightedSteering> wishes;
        for (int k = random.integer(0, 5); k > 0; --k)
            wishes.push_back({randomVec2(random, 3 * agent.maxAcceleration), random.uniform(0, 2)});
        for (const auto& blend : {steerByWeight, steerByBudget, steerByPriority})
            worst = std::max(worst, blend(agent, wishes).norm() / agent.maxAcceleration);
    }
    CHECK(worst < 1 + 6 * 1.1e-16);
}

TEST_CASE("with 6 m/s^2 to spend, wishes of 4 and 4 across are 4 and 2 by budget, 4 by priority", "[steering]") {
    const Agent agent{};
    const std::array wishes{WeightedSteering{{4, 0}}, WeightedSteering{{0, 4}}};
    CHECK(steerByBudget(agent, wishes) == Vec2(4, 2));
    CHECK(steerByPriority(agent, wishes) == Vec2(4, 0));
    CHECK(steerByWeight(agent, wishes) == Vec2(4, 4));  // 5.7 in all
    CHECK(steerByPriority(agent, std::array{WeightedSteering{{0, 0}}, WeightedSteering{{0, 4}, 0.5}}) == Vec2(0, 2));
    CHECK(steerByBudget(agent, std::array{WeightedSteering{{9, 0}}, WeightedSteering{{0, 4}}}) == Vec2(6, 0));
    CHECK((steerByWeight(agent, std::array{WeightedSteering{{3, 4}, 9}}) - Vec2(3.6, 4.8)).norm() < 1e-15);
    CHECK(steerByWeight(agent, {}) == Vec2(0, 0));
    CHECK(steerByPriority(agent, {}) == Vec2(0, 0));
}

TEST_CASE("a wish of less than nothing is refused by name", "[steering][errors]") {
    const std::array wishes{WeightedSteering{{1, 0}, -1}};
    CHECK_THROWS_WITH(steerByWeight({}, wishes), "WeightedSteering.weight: -1 is negative");
    CHECK_THROWS_WITH(steerByBudget({}, wishes), "WeightedSteering.weight: -1 is negative");
    CHECK_THROWS_WITH(steerByPriority({}, wishes), "WeightedSteering.weight: -1 is negative");
    const std::array nothing{WeightedSteering{{std::nan(""), 0}}}, huge{WeightedSteering{{1e200, 0}, 1e200}},
        two{WeightedSteering{{1e308, 0}, 1.5}};
    for (const auto& blend : {steerByWeight, steerByBudget, steerByPriority}) {
        CHECK_THROWS_WITH(blend({}, nothing), "WeightedSteering.acceleration: (nan, 0) is not finite");
        CHECK_THROWS_WITH(blend({}, huge), "WeightedSteering.weight * acceleration: (inf, 0) is not finite");
        CHECK(blend({}, two) == Vec2(6, 0));
    }
}
