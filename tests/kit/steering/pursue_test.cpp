// SPDX-License-Identifier: MIT
#include <plumb/steering/pursue.h>

#include <algorithm>
#include <iostream>

#include <plumb/steering/seek.h>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

namespace {

constexpr double never = 1e9;

/// When the agent is within 0.3 m of what moves straight on [s].
template <typename Behaviour>
double caughtAfter(Agent agent, AgentState quarry, double mostTime, const Behaviour& behaviour) {
    for (int i = 0; i * dt < mostTime; ++i) {
        if ((agent.position - quarry.position).norm() < 0.3) return i * dt;
        agent = moved(agent, behaviour(agent, quarry), dt);
        quarry.position += quarry.velocity * dt;
    }
    return never;
}

double nearestPass(Agent agent, AgentState threat, bool evades) {
    double least = never;
    for (int i = 0; i < 8 * 60; ++i) {
        agent = moved(agent, evades ? evade(agent, threat) : flee(agent, threat.position), dt);
        threat.position += threat.velocity * dt;
        least = std::min(least, (agent.position - threat.position).norm());
    }
    return least;
}

}  // namespace

TEST_CASE("who pursues catches no later than who seeks in 20,000 chases, and a tenth sooner in the mean",
          "[steering]") {
    Random random(83);
    int chases = 0, onlyPursued = 0, later = 0;
    double saved = 0, most = 0;
    for (int i = 0; i < test::cases(20'000); ++i) {
        Agent agent = randomAgent(random);
        agent.velocity = {0, 0};
        agent.maxAcceleration = agent.maxSpeed / random.uniform(0.1, 1);  // it stops within a second
        const AgentState quarry{agent.position + randomOffset(random, 3, 20),
                                agent.maxSpeed * randomOffset(random, 0.3, 0.9)};
        const double time = 200;
        const double pursued =
            caughtAfter(agent, quarry, time, [](const Agent& a, const AgentState& q) { return pursue(a, q, 100); });
        const double sought =
            caughtAfter(agent, quarry, time, [](const Agent& a, const AgentState& q) { return seek(a, q.position); });
        ++chases;
        onlyPursued += pursued < never && sought == never;
        if (pursued == never || sought == never) continue;
        later += pursued > sought;
        saved += (sought - pursued) / sought;
        most = std::max(most, pursued - sought);
    }
    std::cout << "steering: of " << chases << " chases " << onlyPursued << " were won by pursuit only; it saves "
              << 100 * saved / chases << " % of the time in the mean, and is later by at most " << most << " s\n";
    CHECK(later == 0);
    CHECK(saved / chases > 0.1);
}

TEST_CASE("a quarry that would get away through a door is caught by pursuit, and not by seeking", "[steering]") {
    // 5 m from the middle of the floor to the door; the hunter stands 6 m aside of the way, as fast as the quarry.
    const Agent hunter{.position = {3, 4}, .maxSpeed = 3, .maxAcceleration = 30};
    const AgentState quarry{{0, 0}, {2.4, 0}};
    const double door = 5 / 2.4;
    CHECK(caughtAfter(hunter, quarry, door, [](const Agent& a, const AgentState& q) { return pursue(a, q); }) < door);
    CHECK(caughtAfter(hunter, quarry, door, [](const Agent& a, const AgentState& q) { return seek(a, q.position); }) ==
          never);
}

TEST_CASE("who evades 20,000 stampedes is missed by a metre, who flees is not", "[steering]") {
    Random random(84);
    int evaded = 0, fled = 0;
    const int stampedes = test::cases(20'000);
    for (int i = 0; i < stampedes; ++i) {
        Agent agent = randomAgent(random);
        agent.velocity = {0, 0};
        const Vec2 from = randomDirection(random);
        // Twice as fast, straight at a place near the agent.
        const Vec2 aim = agent.position + randomVec2(random, 0.1);
        const AgentState threat{aim + 8 * agent.maxSpeed * from, -2 * agent.maxSpeed * from};
        evaded += nearestPass(agent, threat, true) > 1;
        fled += nearestPass(agent, threat, false) > 1;
    }
    std::cout << "steering: of " << stampedes << " stampedes " << evaded << " missed who evades by a metre, " << fled
              << " who flees\n";
    CHECK(evaded == stampedes);
    CHECK(fled < 0.5 * stampedes);
}

TEST_CASE("who evades a pursuer that heads straight at it runs from it, not into it", "[steering]") {
    CHECK(evade({}, {{10, 0}, {-3, 0}}) == Vec2(-6, 0));
    Random random(86);
    int towards = 0;
    for (int i = 0; i < test::cases(20'000); ++i) {
        const Agent agent{.position = randomVec2(random, 50)};
        const Vec2 from = randomDirection(random);
        const AgentState pursuer{agent.position + random.uniform(0.1, 14) * from, -random.uniform(0, 3) * from};
        towards += evade(agent, pursuer).dot(from) > -5.99;
    }
    CHECK(towards == 0);
    // One that is faster is let by; from right before it, to its left.
    CHECK(evade({}, {{10, 0}, {-4, 0}}) == Vec2(0, -6));
    CHECK(evade({}, {{10, 0.1}, {-4, 0}}) == Vec2(0, -6));
    CHECK(evade({}, {{10, -0.1}, {-4, 0}}) == Vec2(0, 6));
    // The agent is 0.78 m short of 3 t off the line, the pursuer 10 - 4 t along it: (3 10 - 4 0.78) / 5 m at least.
    CHECK(nearestPass({}, {{10, 0}, {-4, 0}}, true) > 5.37);
}

TEST_CASE("a slower pursuer that seeks loses ground in 2,000 chases but for the start", "[steering]") {
    Random random(87);
    double worst = 0;
    int gained = 0;
    const int chases = test::cases(2'000);
    for (int i = 0; i < chases; ++i) {
        Agent agent = randomAgent(random);
        agent.velocity = {0, 0};
        // What it falls short of V t by until it is at V, v' = min(A, (V - v) / t): the integral of V - v.
        const double v = agent.maxSpeed, a = agent.maxAcceleration, t = agent.responseTime;
        const double lost = a * t < v ? v * v / (2 * a) + a * t * t / 2 : v * t;
        const double start = lost * random.uniform(1.5, 5), speed = v * random.uniform(0.3, 0.99);
        const Vec2 from = randomDirection(random);
        Agent hunter{.position = agent.position + start * from, .velocity = -speed * from, .maxSpeed = speed};
        double least = start;
        for (int k = 0; k < 10 * 60; ++k) {
            const Vec2 away = evade(agent, {hunter.position, hunter.velocity});
            const Vec2 closer = seek(hunter, agent.position);
            agent = moved(agent, away, dt);
            hunter = moved(hunter, closer, dt);
            least = std::min(least, (agent.position - hunter.position).norm());
        }
        worst = std::max(worst, (start - least) / lost);
        gained += (agent.position - hunter.position).norm() > start - lost;
    }
    std::cout << "steering: slower pursuers come closer by at most " << worst << " of what the start takes\n";
    CHECK(worst < 1);
    CHECK(gained == chases);
}

TEST_CASE("pursuit aims where a straight course meets: 4 s away for 3 m/s beside 5 m/s", "[steering]") {
    // 16 m off to the side of its way: it goes 12 m in 4 s, and the hunter 20 m.
    const Agent hunter{.maxSpeed = 5, .maxAcceleration = 1e6, .responseTime = 1};
    const Vec2 wanted = pursue(hunter, {{16, 0}, {0, 3}});
    CHECK((wanted - Vec2(4, 3)).norm() < 1e-14);
    // What flies away faster is sought where it is at most ahead.
    CHECK((pursue(hunter, {{1, 0}, {9, 0}}, 2) - Vec2(5, 0)).norm() < 1e-14);
    CHECK(pursue(hunter, {{0, 0}, {0, 3}}).norm() == 0);
    CHECK(evade(hunter, {{0, 0}, {0, 0}}).allFinite());
}

TEST_CASE("looking back in time is refused by name", "[steering][errors]") {
    CHECK_THROWS_WITH(pursue({}, {}, -1), "pursue: mostAhead: -1 is negative");
    CHECK_THROWS_WITH(evade({}, {}, std::nan("")), "evade: mostAhead: nan is not finite");
}

TEST_CASE("who is seen at no place is refused by name", "[steering][errors]") {
    const AgentState nowhere{{std::nan(""), 0}, {1, 0}}, jumping{{1, 0}, {HUGE_VAL, 0}};
    CHECK_THROWS_WITH(pursue({}, nowhere), "AgentState.position: (nan, 0) is not finite");
    CHECK_THROWS_WITH(evade({}, nowhere), "AgentState.position: (nan, 0) is not finite");
    CHECK_THROWS_WITH(pursue({}, jumping), "AgentState.velocity: (inf, 0) is not finite");
    CHECK_THROWS_WITH(evade({}, jumping), "AgentState.velocity: (inf, 0) is not finite");
    CHECK(pursue({}, {{1e200, 0}, {-1e200, 0}}).allFinite());
    CHECK(evade({}, {{1e200, 0}, {-1e200, 0}}) == Vec2(0, -6));
}
