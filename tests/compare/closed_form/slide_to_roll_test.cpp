// SPDX-License-Identifier: MIT
#include <cmath>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

/// Thrown along a floor without turning; k = I / (m r^2).
std::vector<Flight> thrownDisc(double speed, double friction, double k, double radius = 0.5, double gravity = 9.81) {
    const Material material{.friction = friction};
    return flightsIn({.name = "thrown_disc",
                      .gravity = {0, -gravity},
                      .duration = 3,
                      .bodies = {{"floor", {.type = BodyType::Static, .shapes = {segment({-9, 0}, {99, 0}, material)}}},
                                 {"disc",
                                  {.position = {0, radius},
                                   .velocity = {speed, 0},
                                   .mass = Mass{1, {0, 0}, k * radius * radius},
                                   .shapes = {circle(radius, material)}}}},
                      .closedForm = ClosedForm{.bodies = {FreeMotion{"disc"}}}},
                     0);
}

}  // namespace

TEST_CASE("a disc thrown at 3 m/s with a friction of 0.2 rolls at 2 m/s after 0.5096839959 s and 1.2742099898 m",
          "[compare][closed_form][facts][law]") {
    const std::vector<Flight> flights = thrownDisc(3, 0.2, 0.5);
    REQUIRE(flights.size() == 2);  // Worked numbers of response, slide to roll
    CHECK(std::abs(flights[1].start - 0.5096839959) < digits);
    CHECK(std::abs(flights[1].position.x() - 1.2742099898) < digits);
    CHECK((flights[1].velocity - Vec2(2, 0)).norm() < 1e-14);
}

TEST_CASE("a ball thrown at 3 m/s with a friction of 0.2 rolls at 15/7 m/s after 0.4368719965 s and 1.1233851339 m",
          "[compare][closed_form][facts][law]") {
    const std::vector<Flight> flights = thrownDisc(3, 0.2, 0.4);
    REQUIRE(flights.size() == 2);  // Worked numbers of response, slide to roll
    CHECK(std::abs(flights[1].start - 0.4368719965) < digits);
    CHECK(std::abs(flights[1].position.x() - 1.1233851339) < digits);
    CHECK(std::abs(flights[1].velocity.x() - 15.0 / 7) < 1e-14);
}

TEST_CASE("where the thrown disc begins to roll its sliding ends: same speed, same turn, no slip",
          "[compare][closed_form][law]") {
    for (const double k : {0.4, 0.5, 1.0}) {
        const double r = 0.3;
        const std::vector<Flight> flights = thrownDisc(4, 0.3, k, r, 5);
        REQUIRE(flights.size() == 2);
        const Flight& slide = flights[0];
        const Flight& roll = flights[1];
        const double t = roll.start;
        const double rounding = 1e-14;  // of numbers up to 10, after some ten operations
        CHECK((slide.position + slide.velocity * t + slide.acceleration * (t * t / 2) - roll.position).norm() <
              rounding);
        CHECK((slide.velocity + slide.acceleration * t - roll.velocity).norm() < rounding);
        CHECK(std::abs(slide.angularAcceleration * t - roll.angularVelocity) < rounding);
        CHECK(std::abs(slide.angularAcceleration * t * t / 2 - roll.angle) < rounding);
        CHECK(std::abs(roll.velocity.x() + roll.angularVelocity * r) < rounding);
        // About a point of the floor nothing has a moment: v r - k r^2 w = v0 r, with w negative.
        CHECK(std::abs(roll.velocity.x() * r - k * r * r * roll.angularVelocity - 4 * r) < rounding);
    }
}

}  // namespace plumb::compare
