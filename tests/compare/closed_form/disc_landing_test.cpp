// SPDX-License-Identifier: MIT
#include <compare/closed_form/disc_landing.h>

#include <cmath>

#include <plumb/math/random.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double landingRounding = 1e-14;  // of numbers up to 10, after some ten operations

/// A disc of 0.5 m that comes down at 3 m/s with 4 m/s along the floor, and does not turn; e = 0.5.
Flight afterLanding(double friction) {
    const std::vector<Flight> flights = landingFlights(
        {.height = 4.5 / 9.81, .speed = 4, .radius = 0.5, .friction = friction, .restitution = 0.5, .landings = 1});
    REQUIRE(flights.size() == 2);
    return flights[1];
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
    for (int i = 0; i < 1000; ++i) {
        const DroppedDisc disc{.height = random.uniform(0.1, 2),
                               .speed = random.uniform(-3, 3),
                               .angularVelocity = random.uniform(-10, 10),
                               .radius = random.uniform(0.1, 1),
                               .inertiaRatio = random.uniform(0.2, 1),
                               .friction = random.uniform(0, 1),
                               .restitution = random.uniform(0.2, 1),
                               .landings = 4};
        const std::vector<Flight> flights = landingFlights(disc);
        REQUIRE(flights.size() == 5);
        const double spin = disc.inertiaRatio * disc.radius * disc.radius;  // inertia over mass
        for (std::size_t n = 1; n < flights.size(); ++n) {
            const Flight& before = flights[n - 1];
            const Flight& after = flights[n];
            const double s = after.start - before.start;
            const Vec2 landing = before.velocity + before.acceleration * s;
            // What the floor does acts in the floor: vx r - I w / m stays, as r turns the impulse's moment.
            const double momentBefore = landing.x() * disc.radius - spin * before.angularVelocity;
            const double momentAfter = after.velocity.x() * disc.radius - spin * after.angularVelocity;
            CHECK(std::abs(momentBefore - momentAfter) < landingRounding);
            CHECK(std::abs(after.velocity.y() + disc.restitution * landing.y()) <
                  10 * landingRounding);  // times add up
            CHECK(std::abs(slipOf(after, disc.radius)) <= std::abs(slipOf(before, disc.radius)) + landingRounding);
            const double push = std::abs(after.velocity.x() - landing.x());
            CHECK(push <= disc.friction * (after.velocity.y() - landing.y()) + 10 * landingRounding);
        }
    }
}

}  // namespace plumb::compare
