// SPDX-License-Identifier: MIT
// Which agents are there, and what becomes of them?
#pragma once
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/steering/agent.h>

namespace agents {

using plumb::Agent;
using plumb::Random;
using plumb::Vec2;

constexpr double dt = 1.0 / 60;

inline Vec2 randomVec2(Random& random, double size) {
    const double x = random.uniform(-size, size);
    return {x, random.uniform(-size, size)};
}

inline Vec2 randomDirection(Random& random) {
    const double angle = random.uniform(-M_PI, M_PI);
    return {std::cos(angle), std::sin(angle)};
}

/// Any way, by low to high.
inline Vec2 randomOffset(Random& random, double low, double high) {
    const Vec2 direction = randomDirection(random);
    return direction * random.uniform(low, high);
}

/// At 1 to 10 m/s, to brake within 0.1 to 2 s, and to respond within 0.05 to 0.3 s: at 60 Hz no motion of it is coarse.
inline Agent randomAgent(Random& random) {
    Agent agent{.position = randomVec2(random, 20), .radius = random.uniform(0.1, 1)};
    agent.maxSpeed = random.uniform(1, 10);
    agent.maxAcceleration = agent.maxSpeed / random.uniform(0.1, 2);
    agent.responseTime = random.uniform(0.05, 0.3);
    agent.velocity = randomOffset(random, 0, agent.maxSpeed);
    return agent;
}

}  // namespace agents
