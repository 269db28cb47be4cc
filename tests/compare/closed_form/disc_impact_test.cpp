// SPDX-License-Identifier: MIT
#include <compare/closed_form/disc_impact.h>

#include <cmath>

#include <plumb/math/random.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double impactRounding = 1e-15;  // of numbers up to 5, after some ten operations

DiscFlights headOn(double restitution) {
    return collide({.position = {-2, 0}, .velocity = {3, 0}, .mass = 2},
                   {.position = {2, 0}, .velocity = {-1, 0}, .mass = 1}, restitution);
}

/// A disc at 1 m/s hits an equal one at rest; the line between them is 30 degrees off its way.
DiscFlights oblique(double restitution) {
    return collide({.position = {-std::sqrt(0.75) - 2, -0.5}, .velocity = {1, 0}}, {.position = {0, 0}}, restitution);
}

}  // namespace

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s part at 1/3 and 13/3 m/s when e = 1",
          "[compare][closed_form][facts][law]") {
    const DiscFlights flights = headOn(1);  // Worked numbers of response, 1D impact
    REQUIRE(flights.a.size() == 2);
    REQUIRE(flights.b.size() == 2);
    CHECK((flights.a[1].velocity - Vec2(1.0 / 3, 0)).norm() < 5 * impactRounding);
    CHECK((flights.b[1].velocity - Vec2(13.0 / 3, 0)).norm() < 5 * impactRounding);
    CHECK(std::abs(flights.a[1].start - 0.75) < impactRounding);  // a gap of 3 m at 4 m/s
    CHECK((flights.a[1].position - Vec2(0.25, 0)).norm() < 5 * impactRounding);
    CHECK((flights.b[1].position - Vec2(1.25, 0)).norm() < 5 * impactRounding);
}

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s part at 1 and 3 m/s when e = 0.5",
          "[compare][closed_form][facts][law]") {
    const DiscFlights flights = headOn(0.5);  // Worked numbers of response, 1D impact
    CHECK((flights.a[1].velocity - Vec2(1, 0)).norm() < 5 * impactRounding);
    CHECK((flights.b[1].velocity - Vec2(3, 0)).norm() < 5 * impactRounding);
}

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s go on together at 5/3 m/s when e = 0",
          "[compare][closed_form][law]") {
    const DiscFlights flights = headOn(0);  // 2 * 3 - 1 * 1 = 5 kg m/s in 3 kg
    CHECK((flights.a[1].velocity - Vec2(5.0 / 3, 0)).norm() < 5 * impactRounding);
    CHECK((flights.b[1].velocity - Vec2(5.0 / 3, 0)).norm() < 5 * impactRounding);
}

TEST_CASE("equal discs that meet at 30 degrees part at right angles when e = 1", "[compare][closed_form][facts][law]") {
    const DiscFlights flights = oblique(1);  // Worked numbers of response, 2D equal discs, to ten decimals
    CHECK((flights.a[1].velocity - Vec2(0.25, -0.4330127019)).norm() < 1e-10);
    CHECK((flights.b[1].velocity - Vec2(0.75, 0.4330127019)).norm() < 1e-10);
    CHECK(std::abs(flights.a[1].velocity.dot(flights.b[1].velocity)) < impactRounding);
    CHECK(std::abs(flights.a[1].start - 2) < 5 * impactRounding);
}

TEST_CASE("equal discs that meet at 30 degrees with e = 0.8 part as worked out", "[compare][closed_form][facts][law]") {
    const DiscFlights flights = oblique(0.8);  // Worked numbers of response, 2D equal discs, to ten decimals
    CHECK((flights.a[1].velocity - Vec2(0.325, -0.3897114317)).norm() < 1e-10);
    CHECK((flights.b[1].velocity - Vec2(0.675, 0.3897114317)).norm() < 1e-10);
}

TEST_CASE("a disc of 1 m at 10 m/s meets another at (8, 1) m after 0.6267949192 s", "[compare][closed_form][law]") {
    // The lecture, slide 26: radii of 1 m each.
    const auto time = meetingTime({.velocity = {10, 0}, .radius = 1}, {.position = {8, 1}, .radius = 1});
    REQUIRE(time);
    CHECK(std::abs(*time - 0.6267949192) < 6e-11);
}

TEST_CASE("discs that part, pass or stand still do not meet", "[compare][closed_form]") {
    const FlyingDisc still;
    CHECK_FALSE(meetingTime(still, {.position = {3, 0}}));
    CHECK_FALSE(meetingTime(still, {.position = {3, 0}, .velocity = {1, 0}}));
    CHECK_FALSE(meetingTime(still, {.position = {3, 1.001}, .velocity = {-1, 0}}));
    CHECK(meetingTime(still, {.position = {3, 0.999}, .velocity = {-1, 0}}));
    CHECK(collide(still, {.position = {3, 0}}, 1).a.size() == 1);
}

TEST_CASE("1000 random pairs of discs touch when they meet, and not before", "[compare][closed_form]") {
    Random random(11);
    const auto vector = [&](double size) {
        const double x = random.uniform(-size, size);
        return Vec2(x, random.uniform(-size, size));
    };
    int met = 0;
    for (int i = 0; i < 1000; ++i) {
        const FlyingDisc a{.position = vector(1), .velocity = vector(5) + Vec2(5, 0), .radius = random.uniform(0.1, 1)};
        const FlyingDisc b{.position = vector(1) + Vec2(6, 0), .velocity = vector(5), .radius = 0.5};
        const auto time = meetingTime(a, b);
        const auto gapAt = [&](double t) {
            return (b.position + b.velocity * t - a.position - a.velocity * t).norm() - a.radius - b.radius;
        };
        const double end = time.value_or(20);
        for (int k = 0; k < 100; ++k) CHECK(gapAt(end * k / 100) > 0);
        if (!time) continue;
        ++met;
        // The gap's rounding is 1e-15 of 100 m; where they graze, the time has only half the digits, the gap has all.
        CHECK(std::abs(gapAt(*time)) < 1e-12);
    }
    CHECK(met > 100);
}

}  // namespace plumb::compare
