// SPDX-License-Identifier: MIT
#include <plumb/forces/friction.h>

#include <cmath>
#include <iostream>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

// v^2 / (2 mu g) = 25 / 4.905, after 5 / 2.4525 = 2.0387359837 s.
TEST_CASE("a puck at 5 m/s on friction 0.25 slides 5.0968399592 m, and stays", "[forces][law]") {
    const GroundFriction ice{.friction = 0.25};
    // The way of an even slowing is the mean of the two speeds times the time, for each of its parts.
    Vec2 velocity(3, 4);
    double way = 0, time = 0;
    const double part = 1e-3;
    while (velocity != Vec2(0, 0)) {
        const Vec2 next = velocityAfterFriction(ice, velocity, part);
        way += (velocity.norm() + next.norm()) / 2 * part;
        velocity = next;
        time += part;
    }
    CHECK(std::fabs(way - 5.0968399592) < 2.5 * part * part);  // but the last, where it stops within the part
    CHECK(std::fabs(time - 2.0387359837) < part);
    CHECK(velocityAfterFriction(ice, Vec2(3, 4), 2.0387359836) != Vec2(0, 0));
    CHECK(velocityAfterFriction(ice, Vec2(3, 4), 2.0387359838) == Vec2(0, 0));
    CHECK(velocityAfterFriction(ice, Vec2(0, 0), 1) == Vec2(0, 0));
}

TEST_CASE("friction never turns a thing round, and parts of a time add up, 100,000 times", "[forces][law]") {
    Random random(21);
    double worst = 0;
    int faults = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const GroundFriction ground{random.uniform(0, 2), random.uniform(0, 20), random.uniform(0, 1)};
        const Vec2 velocity{random.uniform(-10, 10), random.uniform(-10, 10)};
        const double first = random.uniform(0, 1), second = random.uniform(0, 1);
        const Vec2 half = velocityAfterFriction(ground, velocity, first);
        const Vec2 twice = velocityAfterFriction(ground, half, second);
        const Vec2 once = velocityAfterFriction(ground, velocity, first + second);
        worst = std::max(worst, (once - twice).norm());
        faults += half.dot(velocity) < 0 || half.norm() > velocity.norm();
        // The force is what the velocity's fall says, until it rests.
        const double mass = random.uniform(0.1, 9);
        const Vec2 force = frictionForce(ground, mass, velocity);
        if (half != Vec2(0, 0)) worst = std::max(worst, (velocity + force / mass * first - half).norm());
        const double spin = random.uniform(-9, 9), inertia = random.uniform(0.1, 9);
        const double slower = angularVelocityAfterFriction(ground, mass, inertia, spin, first);
        faults += slower * spin < 0 || std::fabs(slower) > std::fabs(spin);
        if (slower != 0)
            worst = std::max(worst, std::fabs(spin + frictionTorque(ground, mass, spin) / inertia * first - slower));
    }
    std::cout << "forces: friction's closed form is off by at most " << worst << " m/s\n";
    CHECK(worst < 40 * 1.1e-16 * 20);  // some ten roundings of speeds and losses up to 40 m/s, thrice
    CHECK(faults == 0);
}

TEST_CASE("a disc's friction brakes its turning at a lever of 2/3 of its radius", "[forces][law]") {
    // The mean of |r| over a disc of radius 1, by a grid of squares.
    double sum = 0;
    int inside = 0;
    const int half = 500;
    for (int x = -half; x < half; ++x) {
        for (int y = -half; y < half; ++y) {
            const double r = std::hypot(x + 0.5, y + 0.5) / half;
            if (r < 1) sum += r, ++inside;
        }
    }
    CHECK(std::fabs(sum / inside - 2.0 / 3) < 1e-4);
    const double torque = frictionTorque({.friction = 0.5, .lever = 2.0 / 3}, 3, 8);
    CHECK(std::fabs(torque + 0.5 * 3 * 9.81 * 2 / 3) < 1e-14);
    CHECK(frictionTorque({.lever = 1}, 3, 0) == 0);
    CHECK(angularVelocityAfterFriction({.lever = 1}, 3, 1, -8, 100) == 0);
}

TEST_CASE("friction that pushes is refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(frictionForce({.friction = -1}, 1, Vec2(0, 0)), "GroundFriction.friction: -1 is negative");
    CHECK_THROWS_WITH(frictionForce({.gravity = -1}, 1, Vec2(0, 0)), "GroundFriction.gravity: -1 is negative");
    CHECK_THROWS_WITH(frictionTorque({.lever = -1}, 1, 0), "GroundFriction.lever: -1 is negative");
    CHECK_THROWS_WITH(velocityAfterFriction({}, Vec2(0, 0), -1), "velocityAfterFriction: time: -1 is negative");
    CHECK_THROWS_WITH(angularVelocityAfterFriction({}, 1, 0, 0, 1),
                      "angularVelocityAfterFriction: inertia: 0 is not positive");
}
