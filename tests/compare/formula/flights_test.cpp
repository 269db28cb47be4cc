// SPDX-License-Identifier: MIT
#include <compare/formula/flights.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double g = 9.81;

double apexOf(const Flight& flight) {
    return flight.velocity.squaredNorm() / (2 * g);
}

}  // namespace

TEST_CASE("a ball dropped from 1 m at e = 0.8 bounces for 4.0637127689 s along 4.5555555556 m",
          "[compare][formula][facts][law]") {
    const auto flights = bouncingFlights({.height = 1, .restitution = 0.8, .until = 10, .shortestFlight = 1e-12});
    // Worked numbers of response: T = sqrt(2 h / g) (1 + e) / (1 - e), D = h (1 + e^2) / (1 - e^2), to ten decimals.
    // What is cut off, flights below 1e-12 s, adds up to 5e-12 s.
    CHECK(std::abs(flights.back().start - 4.0637127689) < 6e-11);
    double way = 1;
    for (const Flight& flight : flights) way += 2 * apexOf(flight);
    CHECK(std::abs(way - 4.5555555556) < 6e-11);
    CHECK(flights.back().velocity.isZero(0));
    CHECK(flights.back().acceleration.isZero(0));
}

TEST_CASE("a ball dropped from 5 m at e = 1 returns to 5 m twenty times in 40.4 s", "[compare][formula][law]") {
    const auto flights = bouncingFlights({.rest = {3, 0.5}, .height = 5, .restitution = 1, .until = 40.4});
    REQUIRE(flights.size() == 21);
    CHECK(flights[0].position == Vec2(3, 5.5));
    for (std::size_t i = 1; i < flights.size(); ++i) {
        CHECK(std::abs(apexOf(flights[i]) - 5) < 1e-14);
        CHECK(flights[i].position == Vec2(3, 0.5));
    }
    // Each flight lasts 2 sqrt(2 * 5 / 9.81) = 2.0192751093 s, so that the twentieth apex is at 40.3855 s.
    CHECK(std::abs(flights[20].start - 19.5 * 2.0192751093) < 1e-8);
}

TEST_CASE("of a ball dropped from 2.7 m at e = 0.8 seventeen flights are longer than 1/30 s", "[compare][formula]") {
    const auto flights = bouncingFlights({.height = 2.7, .restitution = 0.8, .until = 10, .shortestFlight = 1.0 / 30});
    REQUIRE(flights.size() == 1 + 17 + 1);
    CHECK(2 * flights[17].velocity.y() / g > 1.0 / 30);
    CHECK(0.8 * 2 * flights[17].velocity.y() / g < 1.0 / 30);
    CHECK(flights[18].velocity.isZero(0));
}

TEST_CASE("flights that start after the end are left out", "[compare][formula]") {
    // The fall from 5 m takes 1.0096 s.
    CHECK(bouncingFlights({.height = 5, .until = 1.0}).size() == 1);
    CHECK(bouncingFlights({.height = 5, .until = 1.01}).size() == 2);
}

}  // namespace plumb::compare
