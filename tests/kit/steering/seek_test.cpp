// SPDX-License-Identifier: MIT
#include <plumb/steering/seek.h>

#include <algorithm>
#include <iostream>

#include "cases.h"
#include "catch.h"
#include "kit/steering/agents.h"

using namespace plumb;
using namespace agents;

TEST_CASE("an agent that seeks passes its target at full speed, and comes back", "[steering]") {
    Agent agent{.position = {-10, 0}, .velocity = {0, 1}};
    int passes = 0;
    double fastest = 0;
    for (int i = 0; i < 20 * 60; ++i) {
        const Agent before = agent;
        agent = moved(agent, seek(agent, {0, 0}), dt);
        const bool passed = before.position.x() < 0 && agent.position.x() >= 0;
        if (passed) fastest = std::max(fastest, agent.velocity.norm());
        passes += passed;
    }
    CHECK(passes > 3);
    CHECK(fastest > 0.99 * agent.maxSpeed);
}

TEST_CASE("who flees is as far away after 10 s as full speed allows, but for turning round", "[steering]") {
    Random random(81);
    for (int i = 0; i < test::cases(10'000); ++i) {
        Agent agent = randomAgent(random);
        const Vec2 threat = agent.position + randomOffset(random, 0.1, 5);
        for (int k = 0; k < 600; ++k) agent = moved(agent, flee(agent, threat), dt);
        // Turning round takes 2 V / A and some response times, in which it may go the other way at V.
        const double lost = 2 * (2 * agent.maxSpeed / agent.maxAcceleration + 5 * agent.responseTime) * agent.maxSpeed;
        CHECK((agent.position - threat).norm() > 10 * agent.maxSpeed - lost);
    }
}

TEST_CASE("10,000 agents arrive, stay, and swing past by less than 1 % of the slowing distance", "[steering]") {
    Random random(82);
    double worst = 0, off = 0;
    for (int i = 0; i < test::cases(10'000); ++i) {
        Agent agent = randomAgent(random);
        const double slowing = slowingDistanceOf(agent);
        // From where it has room to brake, or to turn round.
        const Vec2 target = agent.position + slowing * randomOffset(random, 1.5, 5);
        double least = 1e9, swing = 0;
        // The way there at V, and at the end e^(-V t / D) of D: fifteen times D / V is 3e-7 of it.
        const double time = 22 * slowing / agent.maxSpeed;
        for (int k = 0; k < time / dt; ++k) {
            agent = moved(agent, arrive(agent, target), dt);
            const double distance = (agent.position - target).norm();
            least = std::min(least, distance);
            if (distance < slowing) swing = std::max(swing, distance - least);
            if (distance > slowing) least = 1e9, swing = 0;  // not yet there: it turns round first
        }
        worst = std::max(worst, swing / slowing);
        off = std::max(off, (agent.position - target).norm() / slowing);
    }
    std::cout << "steering: who arrives swings past by at most " << worst << ", and ends " << off
              << " of the slowing distance off\n";
    CHECK(worst < 0.01);
    CHECK(off < 1e-5);
}

TEST_CASE("on the target itself nobody knows where to", "[steering]") {
    const Agent agent{.position = {3, 4}, .velocity = {1, 0}};
    CHECK(seek(agent, {3, 4}) == Vec2(0, 0));
    CHECK(flee(agent, {3, 4}) == Vec2(6, 0));                     // straight on
    CHECK((arrive(agent, {3, 4}) - Vec2(-6, 0)).norm() < 1e-15);  // stays
    CHECK(arrive({.position = {3, 4}}, {3, 4}) == Vec2(0, 0));
    CHECK((steerTo({.velocity = {1, 0}}, {1.3, 0}) - Vec2(3, 0)).norm() < 1e-14);  // 0.3 m/s within 0.1 s
}

TEST_CASE("who is to arrive at 1e160 m goes there, as at 100 m", "[steering]") {
    const Vec2 near = arrive({}, {60, 80});
    CHECK((near - Vec2(3.6, 4.8)).norm() < 1e-15);
    for (const double far : {1e150, 1e160, 1e300, 1.5e308}) {
        CHECK((arrive({}, {0.6 * far, 0.8 * far}) - near).norm() < 1e-14);
        CHECK((seek({}, {0.6 * far, 0.8 * far}) - near).norm() < 1e-14);
        CHECK((flee({}, {0.6 * far, 0.8 * far}) + near).norm() < 1e-14);
    }
    CHECK((seek({}, {6e-201, 8e-201}) - near).norm() < 1e-14);
    // Wishes beyond all numbers are cut down to what there is, and no less.
    CHECK(steerTo({.maxSpeed = 1e200, .responseTime = 1e-200}, {1e200, 0}) == Vec2(6, 0));
    CHECK(steerTo({.velocity = {-1.5e308, 0}, .maxSpeed = 1e308}, {1.5e308, 0}) == Vec2(6, 0));
    CHECK(arrive({}, {0, 0}, 5e-324) == Vec2(0, 0));
}

TEST_CASE("agents that nothing moves are refused by name", "[steering][errors]") {
    CHECK_THROWS_WITH(seek({.maxSpeed = 0}, {1, 1}), "Agent.maxSpeed: 0 is not positive");
    CHECK_THROWS_WITH(flee({.maxAcceleration = -1}, {1, 1}), "Agent.maxAcceleration: -1 is not positive");
    CHECK_THROWS_WITH(arrive({.responseTime = std::nan("")}, {1, 1}), "Agent.responseTime: nan is not finite");
    CHECK_THROWS_WITH(seek({.radius = -1}, {1, 1}), "Agent.radius: -1 is negative");
    CHECK_THROWS_WITH(arrive({}, {1, 1}, 0.0), "arrive: slowingDistance: 0 is not positive");
    CHECK_THROWS_WITH(moved({}, {1, 1}, -1), "moved: dt: -1 is negative");
    const double nan = std::nan("");
    CHECK_THROWS_WITH(seek({}, {nan, 0}), "seek: target: (nan, 0) is not finite");
    CHECK_THROWS_WITH(flee({}, {nan, 0}), "flee: threat: (nan, 0) is not finite");
    CHECK_THROWS_WITH(arrive({}, {nan, 0}), "arrive: target: (nan, 0) is not finite");
    CHECK_THROWS_WITH(arrive({.velocity = {nan, 0}}, {1, 0}), "Agent.velocity: (nan, 0) is not finite");
    CHECK_THROWS_WITH(seek({.position = {0, HUGE_VAL}}, {1, 0}), "Agent.position: (0, inf) is not finite");
    CHECK_THROWS_WITH(seek({.position = {-1e308, 0}}, {1e308, 0}),
                      "seek: target - Agent.position: (inf, 0) is not finite");
    CHECK_THROWS_WITH(steerTo({}, {nan, 0}), "steerTo: wantedVelocity: (nan, 0) is not finite");
    CHECK_THROWS_WITH(moved({}, {nan, 0}, 1), "moved: acceleration: (nan, 0) is not finite");
}
