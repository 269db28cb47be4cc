// SPDX-License-Identifier: MIT
#include <plumb/forces/attractor.h>

#include <cmath>
#include <limits>

#include "catch.h"
#include "kit/forces/runge_kutta.h"

using namespace plumb;

namespace {

test::State<4> flown(const Attractor& attractor, const test::State<4>& start, double time, int steps) {
    return test::integrated<4>(start, time, steps, [&attractor](const test::State<4>& s) -> test::State<4> {
        test::State<4> rate;
        rate << s.tail<2>(), attraction(attractor, s.head<2>());
        return rate;
    });
}

}  // namespace

TEST_CASE("1 kg on a circle around any power of the distance is back after one turn", "[forces][law]") {
    for (int power = 1; power <= 8; ++power) {
        const Attractor attractor{.center = {1, 2}, .strength = 5, .power = power};
        const double radius = 2;
        const double speed = std::sqrt(5 / std::pow(radius, power - 1));  // v^2 / r = S / r^n
        test::State<4> start;
        start << 1 + radius, 2, 0, speed;
        const test::State<4> end = flown(attractor, start, 2 * M_PI * radius / speed, 2000);
        // (2 pi / 2000)^5 / 120 a step, 2000 times; from n = 3 on circles run away, by e^(2 pi sqrt(n - 3)) a turn.
        CHECK((end - start).norm() < 2 * 2e-11 * speed * std::exp(2 * M_PI * std::sqrt(std::max(0, power - 3))));
    }
}

TEST_CASE("at 2 m a strength of 24 pulls with 12 N, 6 N, 3 N, and so on", "[forces][law]") {
    double pull = 12;
    for (int power = 1; power <= 8; ++power, pull /= 2) {
        const Vec2 force = attraction({.center = {0, 1}, .strength = 24, .power = power}, {0, 3});
        CHECK(std::fabs(force.y() + pull) < 1e-14);
        CHECK(force.x() == 0);
    }
    CHECK(attraction({.strength = -24, .power = 1}, {2, 0}) == Vec2(12, 0));
}

TEST_CASE("what crosses the edge of an attractor's range and comes out again keeps its energy", "[forces][law]") {
    for (const int power : {1, 2, 3}) {
        const Attractor attractor{.strength = 3, .power = power, .softening = 0.1, .range = 2};
        test::State<4> start;
        start << -3, 0.7, 2, 0;
        const auto energy = [&attractor](const test::State<4>& s) -> double {
            return s.tail<2>().squaredNorm() / 2 + potentialEnergy(attractor, s.head<2>());
        };
        const test::State<4> inside = flown(attractor, start, 1.4, 14'000), after = flown(attractor, start, 6, 60'000);
        CHECK(inside.head<2>().norm() < 1);
        CHECK(after.head<2>().norm() > 2);
        CHECK(energy(start) == 2);
        // A step of 1e-4 s that crosses the edge has the force for a part of it: 1.5 N at 2.5 m/s.
        CHECK(std::fabs(energy(inside) - 2) < 4e-4);
        CHECK(std::fabs(energy(after) - 2) < 8e-4);
    }
}

TEST_CASE("energies of attractors are as tables have them", "[forces][law]") {
    CHECK(std::fabs(potentialEnergy(Attractor{.strength = 2, .power = 1}, {0, 10}) - 2 * 2.302585092994046) < 1e-15);
    CHECK(potentialEnergy(Attractor{.strength = 6, .power = 2}, {0, 3}) == -2);
    CHECK(std::fabs(potentialEnergy(Attractor{.strength = 6, .power = 4}, {0, 2}) + 0.25) < 1e-16);
    CHECK(potentialEnergy(Attractor{.range = 2}, {0, 2}) == 0);
    CHECK(potentialEnergy(Attractor{.range = 2}, {0, 7}) == 0);
    CHECK(std::fabs(potentialEnergy(Attractor{.range = 2}, {0, 1}) + 0.5) < 1e-16);
}

TEST_CASE("at its centre an attractor has no direction, and no NaN", "[forces]") {
    for (const double softening : {0.0, 0.5}) {
        for (int power = 1; power <= 8; ++power) {
            const Attractor attractor{.center = {3, 4}, .power = power, .softening = softening};
            CHECK(attraction(attractor, {3, 4}) == Vec2(0, 0));
            const Attractor hole{.power = power, .softening = softening};
            CHECK(attraction(hole, {0, 1e-80}).allFinite());
            CHECK(attraction(hole, {1e200, 1e200}).isZero(1e-190));
            CHECK_FALSE(std::isnan(potentialEnergy(hole, {0, 0})));
            CHECK_FALSE(std::isnan(potentialEnergy(hole, {0, 1e200})));
        }
    }
}

TEST_CASE("attractors that nothing is are refused by name", "[forces][errors]") {
    const auto at = [](const Attractor& attractor) { return attraction(attractor, {1, 1}); };
    CHECK_THROWS_WITH(at({.power = 0}), "Attractor.power: 0 is not within 1 to 8");
    CHECK_THROWS_WITH(at({.power = 1'000'000'000}), "Attractor.power: 1000000000 is not within 1 to 8");
    CHECK_THROWS_WITH(at({.softening = -1}), "Attractor.softening: -1 is negative");
    CHECK_THROWS_WITH(at({.range = 0}), "Attractor.range: 0 is not positive");
    CHECK_THROWS_WITH(at({.range = std::nan("")}), "Attractor.range: nan is not finite");
    CHECK_THROWS_WITH(at({.strength = std::nan("")}), "Attractor.strength: nan is not finite");
}
