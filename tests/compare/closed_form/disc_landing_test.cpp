// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/math/random.h>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

constexpr double landingRounding = 1e-13;  // of numbers up to 10, after some hundred operations

struct DroppedDisc {
    double height = 1;                        ///< above where it touches the floor [m]
    double speed = 0, angularVelocity = 0;    ///< [m/s], [rad/s]
    double radius = 0.5, inertiaRatio = 0.5;  ///< [m], I / (m r^2) [-]
    double friction = 0.5, restitution = 0.5;
};

/// Its flights of four seconds over a wide floor, and what lies after them.
std::vector<Flight> flightsOf(const DroppedDisc& disc) {
    const Material material{.friction = disc.friction, .restitution = disc.restitution};
    return flightsIn(
        {.name = "dropped_disc",
         .duration = 4,
         .bodies = {{"floor", {.type = BodyType::Static, .shapes = {segment({-99, 0}, {99, 0}, material)}}},
                    {"disc",
                     {.position = {0, disc.radius + disc.height},
                      .velocity = {disc.speed, 0},
                      .angularVelocity = disc.angularVelocity,
                      .mass = Mass{1, {0, 0}, disc.inertiaRatio * disc.radius * disc.radius},
                      .shapes = {circle(disc.radius, material)}}}},
         .closedForm = ClosedForm{.bodies = {FreeMotion{"disc"}}}},
        0);
}

/// A disc of 0.5 m that comes down at 3 m/s with 4 m/s along the floor, and does not turn; e = 0.5.
Flight afterLanding(double friction) {
    return flightsOf({.height = 4.5 / 9.81, .speed = 4, .friction = friction}).at(1);
}

double slipOf(const Flight& flight, double radius) {
    return flight.velocity.x() + flight.angularVelocity * radius;
}

}  // namespace

TEST_CASE("a disc that lands at (4, -3) m/s with e = 0.5 sticks from a friction of 8/27 on",
          "[compare][closed_form][facts][law]") {
    // Worked numbers of response, disc on floor: both cases and the threshold between them.
    const Flight sticks = afterLanding(0.5);
    CHECK((sticks.velocity - Vec2(8.0 / 3, 1.5)).norm() < landingRounding);
    CHECK(std::abs(sticks.angularVelocity + 16.0 / 3) < landingRounding);
    const Flight slips = afterLanding(0.2);
    CHECK((slips.velocity - Vec2(3.1, 1.5)).norm() < landingRounding);
    CHECK(std::abs(slips.angularVelocity + 3.6) < landingRounding);
    CHECK(std::abs(slipOf(afterLanding(8.0 / 27 + 1e-6), 0.5)) < landingRounding);
    CHECK(slipOf(afterLanding(8.0 / 27 - 1e-6), 0.5) > 1e-6);
}

TEST_CASE("1,000 dropped discs keep their angular momentum about the floor at each landing, and never slip more",
          "[compare][closed_form][law]") {
    Random random(1);
    std::size_t landings = 0;
    for (int i = 0; i < 1000; ++i) {
        const DroppedDisc disc{.height = random.uniform(0.1, 2),
                               .speed = random.uniform(-3, 3),
                               .angularVelocity = random.uniform(-10, 10),
                               .radius = random.uniform(0.1, 1),
                               .inertiaRatio = random.uniform(0.2, 1),
                               .friction = random.uniform(0, 1),
                               .restitution = random.uniform(0.2, 1)};
        const std::vector<Flight> flights = flightsOf(disc);
        const double spin = disc.inertiaRatio * disc.radius * disc.radius;  // inertia over mass
        for (std::size_t n = 1; n < std::min<std::size_t>(flights.size(), 5); ++n) {
            const Flight& before = flights[n - 1];
            const Flight& after = flights[n];
            const double s = after.start - before.start;
            const Vec2 landing = before.velocity + before.acceleration * s;
            if (after.velocity.y() == 0 || landing.y() == 0) break;  // it lies on the floor
            ++landings;
            // What the floor does acts in the floor: vx r - I w / m stays, as r turns the impulse's moment.
            const double momentBefore = landing.x() * disc.radius - spin * before.angularVelocity;
            const double momentAfter = after.velocity.x() * disc.radius - spin * after.angularVelocity;
            CHECK(std::abs(momentBefore - momentAfter) < landingRounding);
            CHECK(std::abs(after.velocity.y() + disc.restitution * landing.y()) < landingRounding);
            CHECK(std::abs(slipOf(after, disc.radius)) <= std::abs(slipOf(before, disc.radius)) + landingRounding);
            const double push = std::abs(after.velocity.x() - landing.x());
            CHECK(push <= disc.friction * (after.velocity.y() - landing.y()) + landingRounding);
        }
    }
    CHECK(landings > 2000);
}

}  // namespace plumb::compare
