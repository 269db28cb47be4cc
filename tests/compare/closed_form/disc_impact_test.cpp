// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/builtin.h>
#include <plumb/math/random.h>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

constexpr double impactRounding = 1e-14;  // of numbers up to 5, after some twenty operations

struct SmoothDisc {
    Vec2 position{0, 0};
    Vec2 velocity{0, 0};
    double radius = 0.5;
};

/// Two smooth elastic discs that nothing else acts on.
Scene twoDiscs(const SmoothDisc& a, const SmoothDisc& b) {
    Scene scene{.name = "two_discs", .gravity = {0, 0}, .duration = 20, .closedForm = ClosedForm{}};
    for (const SmoothDisc& disc : {a, b}) {
        const std::string name = scene.bodies.empty() ? "a" : "b";
        scene.bodies.push_back({name,
                                {.position = disc.position,
                                 .velocity = disc.velocity,
                                 .shapes = {circle(disc.radius, {.friction = 0, .restitution = 1})}}});
        scene.closedForm->bodies.push_back(FreeMotion{name});
    }
    return scene;
}

/// When they meet; never: 0.
double meetingTime(const SmoothDisc& a, const SmoothDisc& b) {
    const std::vector<Flight> flights = flightsIn(twoDiscs(a, b), 0);
    return flights.size() > 1 ? flights[1].start : 0;
}

}  // namespace

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s part at 1/3 and 13/3 m/s when e = 1",
          "[compare][closed_form][facts][law]") {
    const Scene scene = findScene("head_on_1").value();
    const std::vector<Flight> a = flightsIn(scene, 0), b = flightsIn(scene, 1);
    REQUIRE(a.size() == 2);  // Worked numbers of response, 1D impact
    REQUIRE(b.size() == 2);
    CHECK((a[1].velocity - Vec2(1.0 / 3, 0)).norm() < impactRounding);
    CHECK((b[1].velocity - Vec2(13.0 / 3, 0)).norm() < impactRounding);
    CHECK(std::abs(a[1].start - 0.775) < impactRounding);  // a gap of 3.1 m at 4 m/s
    CHECK((a[1].position - Vec2(0.225, 0)).norm() < impactRounding);
    CHECK((b[1].position - Vec2(1.225, 0)).norm() < impactRounding);
}

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s part at 1 and 3 m/s when e = 0.5",
          "[compare][closed_form][facts][law]") {
    const Scene scene = findScene("head_on_05").value();  // Worked numbers of response, 1D impact
    CHECK((flightsIn(scene, 0).at(1).velocity - Vec2(1, 0)).norm() < impactRounding);
    CHECK((flightsIn(scene, 1).at(1).velocity - Vec2(3, 0)).norm() < impactRounding);
}

TEST_CASE("discs of 2 kg and 1 kg at 3 and -1 m/s go on together at 5/3 m/s when e = 0",
          "[compare][closed_form][law]") {
    const Scene scene = findScene("head_on_0").value();  // 2 * 3 - 1 * 1 = 5 kg m/s in 3 kg
    CHECK((flightsIn(scene, 0).at(1).velocity - Vec2(5.0 / 3, 0)).norm() < impactRounding);
    CHECK((flightsIn(scene, 1).at(1).velocity - Vec2(5.0 / 3, 0)).norm() < impactRounding);
}

TEST_CASE("equal discs that meet at 30 degrees part at right angles when e = 1", "[compare][closed_form][facts][law]") {
    const Scene scene = findScene("oblique_1").value();
    const Flight a = flightsIn(scene, 0).at(1), b = flightsIn(scene, 1).at(1);
    CHECK((a.velocity - Vec2(0.25, -0.4330127019)).norm() < digits);  // Worked numbers of response, 2D equal discs
    CHECK((b.velocity - Vec2(0.75, 0.4330127019)).norm() < digits);
    CHECK(std::abs(a.velocity.dot(b.velocity)) < impactRounding);
    CHECK(std::abs(a.start - 1.01) < impactRounding);
}

TEST_CASE("equal discs that meet at 30 degrees with e = 0.8 part as worked out", "[compare][closed_form][facts][law]") {
    const Scene scene = findScene("oblique_08").value();  // Worked numbers of response, 2D equal discs
    CHECK((flightsIn(scene, 0).at(1).velocity - Vec2(0.325, -0.3897114317)).norm() < digits);
    CHECK((flightsIn(scene, 1).at(1).velocity - Vec2(0.675, 0.3897114317)).norm() < digits);
}

TEST_CASE("a disc of 1 m at 10 m/s meets another at (8, 1) m after 0.6267949192 s", "[compare][closed_form][law]") {
    // The lecture, slide 26: radii of 1 m each.
    const double time = meetingTime({.velocity = {10, 0}, .radius = 1}, {.position = {8, 1}, .radius = 1});
    CHECK(std::abs(time - 0.6267949192) < digits);
}

TEST_CASE("discs that part, pass or stand still do not meet", "[compare][closed_form]") {
    const SmoothDisc still;
    CHECK(meetingTime(still, {.position = {3, 0}}) == 0);
    CHECK(meetingTime(still, {.position = {3, 0}, .velocity = {1, 0}}) == 0);
    CHECK(meetingTime(still, {.position = {3, 1.001}, .velocity = {-1, 0}}) == 0);
    CHECK(meetingTime(still, {.position = {3, 0.999}, .velocity = {-1, 0}}) > 0);
}

TEST_CASE("1000 random pairs of discs touch when they meet, and not before", "[compare][closed_form]") {
    Random random(11);
    const auto vector = [&](double size) {
        const double x = random.uniform(-size, size);
        return Vec2(x, random.uniform(-size, size));
    };
    int met = 0;
    for (int i = 0; i < 1000; ++i) {
        const SmoothDisc a{vector(1), vector(5) + Vec2(5, 0), random.uniform(0.1, 1)};
        const SmoothDisc b{vector(1) + Vec2(6, 0), vector(5), 0.5};
        const double time = meetingTime(a, b);
        const auto gapAt = [&](double t) {
            return (b.position + b.velocity * t - a.position - a.velocity * t).norm() - a.radius - b.radius;
        };
        const double end = time > 0 ? time : 20;
        for (int k = 0; k < 100; ++k) CHECK(gapAt(end * k / 100) > 0);
        if (time == 0) continue;
        ++met;
        // The gap's rounding is 1e-15 of 100 m; where they graze, the time has only half the digits, the gap has all.
        CHECK(std::abs(gapAt(time)) < 1e-12);
    }
    CHECK(met > 100);
}

}  // namespace plumb::compare
