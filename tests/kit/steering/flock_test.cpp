// SPDX-License-Identifier: MIT
#include <plumb/steering/flock.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <vector>

#include <plumb/steering/blend.h>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

using Flock = std::vector<Agent>;

std::vector<AgentState> seen(const Flock& flock) {
    std::vector<AgentState> all;
    for (const Agent& agent : flock) all.push_back({agent.position, agent.velocity});
    return all;
}

Flock randomFlock(Random& random, int size, double spread) {
    Flock flock;
    for (int i = 0; i < size; ++i)
        flock.push_back({.position = randomVec2(random, spread), .velocity = 3 * randomDirection(random)});
    return flock;
}

/// Each by what it sees of all at the start of the step.
template <typename Behaviour>
Flock flown(Flock flock, double seconds, const Behaviour& behaviour) {
    for (int i = 0; i * dt < seconds; ++i) {
        const std::vector<AgentState> all = seen(flock);
        for (Agent& agent : flock) agent = moved(agent, behaviour(agent, all), dt);
    }
    return flock;
}

/// 1 when all fly the same way, near 0 when each flies its own.
double order(const Flock& flock) {
    Vec2 sum(0, 0);
    for (const Agent& agent : flock) sum += headingOf(agent);
    return sum.norm() / static_cast<double>(flock.size());
}

double leastDistance(const Flock& flock) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < flock.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, (flock[i].position - flock[k].position).norm());
    return least;
}

/// The root of the mean square distance from the middle.
double spreadOf(const Flock& flock) {
    Vec2 middle(0, 0);
    for (const Agent& agent : flock) middle += agent.position / static_cast<double>(flock.size());
    double sum = 0;
    for (const Agent& agent : flock) sum += (agent.position - middle).squaredNorm();
    return std::sqrt(sum / static_cast<double>(flock.size()));
}

}  // namespace

TEST_CASE("the headings of 30 flocks of thirty that align come together", "[steering]") {
    Random random(94);
    double worst = 1, before = 0;
    for (int i = 0; i < 30; ++i) {
        const Flock flock = randomFlock(random, 30, 5);
        const Flock after = flown(flock, 5, [](const Agent& a, const std::vector<AgentState>& all) {
            return align(a, all, {.radius = 100});
        });
        worst = std::min(worst, order(after));
        before = std::max(before, order(flock));
    }
    std::cout << "steering: flocks that align fly the same way to " << worst << " at least, from " << before
              << " at most\n";
    CHECK(worst > 0.999);
    CHECK(before < 0.6);
}

TEST_CASE("30 flocks of thirty that cohere shrink to a tenth, and no agent flies off", "[steering][slow]") {
    Random random(95);
    double worst = 0;
    for (int i = 0; i < 30; ++i) {
        const Flock flock = randomFlock(random, 30, 10);
        const Flock after = flown(flock, 30, [](const Agent& a, const std::vector<AgentState>& all) {
            return cohere(a, all, {.radius = 100});
        });
        worst = std::max(worst, spreadOf(after) / spreadOf(flock));
    }
    std::cout << "steering: flocks that cohere shrink to " << worst << " at most\n";
    CHECK(worst < 0.1);
}

TEST_CASE("thirty that separate and come to rest are no nearer than their radius to each other", "[steering]") {
    Random random(96);
    double worst = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 30; ++i) {
        const Flock after =
            flown(randomFlock(random, 30, 3), 30, [](const Agent& a, const std::vector<AgentState>& all) {
                // Only the push; and a brake, as between people who stand about.
                return steerByWeight(a, std::array{WeightedSteering{separate(a, all, {.radius = 2})},
                                                   WeightedSteering{steerTo(a, {0, 0}), 0.1}});
            });
        worst = std::min(worst, leastDistance(after));
    }
    std::cout << "steering: who separates comes to " << worst << " of 2 m at least\n";
    CHECK(worst > 1.9);
}

TEST_CASE("a flock that does all three stays together, flies the same way and keeps its distances",
          "[steering][slow]") {
    Random random(97);
    double order0 = 1, least = 1e9, spread = 0;
    for (int i = 0; i < 20; ++i) {
        const Flock after =
            flown(randomFlock(random, 30, 6), 40, [](const Agent& a, const std::vector<AgentState>& all) {
                return steerByWeight(a, std::array{WeightedSteering{separate(a, all, {.radius = 2}), 1.5},
                                                   WeightedSteering{align(a, all, {.radius = 6})},
                                                   WeightedSteering{cohere(a, all, {.radius = 20}), 0.3},
                                                   WeightedSteering{steerTo(a, a.maxSpeed * headingOf(a)), 0.5}});
            });
        order0 = std::min(order0, order(after));
        least = std::min(least, leastDistance(after));
        spread = std::max(spread, spreadOf(after));
    }
    std::cout << "steering: flocks fly the same way to " << order0 << ", " << least << " m apart at least, within "
              << spread << " m\n";
    CHECK(order0 > 0.95);
    CHECK(least > 0.3);
    CHECK(spread < 8);
}

TEST_CASE("two at half their radius push each other with half of what they have, and alike", "[steering]") {
    const Agent a{.position = {0, 0}}, b{.position = {1, 0}};
    const std::vector<AgentState> all{{a.position, {0, 0}}, {b.position, {0, 0}}};
    CHECK(separate(a, all, {.radius = 2}) == Vec2(-3, 0));
    CHECK(separate(b, all, {.radius = 2}) == Vec2(3, 0));
    CHECK(separate(a, all, {.radius = 1}) == Vec2(0, 0));
}

TEST_CASE("who looks ahead sees nobody behind, and those at one place count for nobody", "[steering]") {
    const Agent agent{.velocity = {0, 2}};
    const std::vector<AgentState> all{{{0, -1}, {1, 0}}, {{0, 0}, {5, 5}}};
    CHECK(align(agent, all, {.view = 1}) == Vec2(0, 0));
    CHECK(align(agent, all).x() > 0);
    CHECK(cohere(agent, std::vector<AgentState>{{{0, 0}, {5, 5}}}) == Vec2(0, 0));
    CHECK(separate(agent, std::vector<AgentState>{{{0, 0}, {5, 5}}}) == Vec2(0, 0));
    CHECK(separate(agent, {}) == Vec2(0, 0));
}

TEST_CASE("neighbourhoods that nothing has are refused by name", "[steering][errors]") {
    CHECK_THROWS_WITH(separate({}, {}, {.radius = 0}), "Neighborhood.radius: 0 is not positive");
    CHECK_THROWS_WITH(align({}, {}, {.view = -1}), "Neighborhood.view: -1 is not within 0 to 3.141592653589793");
    CHECK_THROWS_WITH(cohere({.maxSpeed = 0}, {}), "Agent.maxSpeed: 0 is not positive");
    const std::vector<AgentState> nowhere{{{std::nan(""), 0}, {0, 0}}};
    CHECK_THROWS_WITH(separate({}, nowhere), "AgentState.position: (nan, 0) is not finite");
    CHECK_THROWS_WITH(align({}, nowhere), "AgentState.position: (nan, 0) is not finite");
    CHECK_THROWS_WITH(cohere({}, nowhere), "AgentState.position: (nan, 0) is not finite");
}
