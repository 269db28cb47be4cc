// SPDX-License-Identifier: MIT
#include <plumb/stepping/interpolate.h>

#include <plumb/math/random.h>

#include <cmath>
#include <numbers>

#include "catch.h"

using namespace plumb;
using std::numbers::pi;

TEST_CASE("a quarter of the way from (1, 2) to (5, 0) is (2, 1.5), and the start is exact", "[stepping]") {
    CHECK(interpolate(Vec2(1, 2), Vec2(5, 0), 0.25) == Vec2(2, 1.5));
    CHECK(interpolate(Vec2(0.1, 0.7), Vec2(5, 0), 0) == Vec2(0.1, 0.7));
    CHECK(interpolate(Vec2(0.1, 0.7), Vec2(0.1, 0.7), 0.3) == Vec2(0.1, 0.7));
    CHECK(interpolate(3, 4, 0.5) == 3.5);
}

TEST_CASE("an angle takes the shorter way round", "[stepping]") {
    CHECK(std::fabs(interpolateAngle(3, -3, 0.5) - pi) < 1e-15);
    CHECK(std::fabs(interpolateAngle(-3, 3, 0.5) + pi) < 1e-15);
    CHECK(std::fabs(shortestTurn(3, -3) - (2 * pi - 6)) < 1e-15);
    CHECK(std::fabs(shortestTurn(0.5, 0.5 + 20 * pi)) < 1e-14);
    Random random(53);
    for (int i = 0; i < 10'000; ++i) {
        const double from = random.uniform(-20, 20), to = random.uniform(-20, 20), fraction = random.uniform(0, 1);
        const double turn = shortestTurn(from, to);
        CHECK(std::fabs(turn) <= pi);
        CHECK(std::fabs(std::sin(from + turn) - std::sin(to)) < 2e-14);
        CHECK(std::fabs(std::cos(from + turn) - std::cos(to)) < 2e-14);
        CHECK(std::fabs(interpolateAngle(from, to, fraction) - (from + fraction * turn)) < 1e-14);
    }
}

// The truth: complex numbers to a power, by the library's own sine and cosine.
TEST_CASE("a pose turns evenly the shorter way while it moves straight", "[stepping]") {
    Random random(59);
    for (int i = 0; i < 10'000; ++i) {
        const double angle = random.uniform(-3, 3), turn = random.uniform(-3.1, 3.1), fraction = random.uniform(0, 1);
        const Transform from{{1, 2}, Rot::fromAngle(angle)}, to{{3, -2}, Rot::fromAngle(angle + turn)};
        const Transform between = interpolate(from, to, fraction);
        CHECK(std::fabs(between.rotation.cos - std::cos(angle + fraction * turn)) < 3e-15);
        CHECK(std::fabs(between.rotation.sin - std::sin(angle + fraction * turn)) < 3e-15);
        CHECK((between.position - Vec2(1 + 2 * fraction, 2 - 4 * fraction)).norm() < 1e-15);
    }
    const Transform pose{{0.1, 0.2}, Rot::fromAngle(0.3)};
    const Transform start = interpolate(pose, {{5, 5}, Rot::fromAngle(2)}, 0);
    CHECK(start.position == pose.position);
    CHECK(start.rotation.cos == pose.rotation.cos);
    CHECK(start.rotation.sin == pose.rotation.sin);
}

TEST_CASE("a fraction outside 0 to 1 is refused by name", "[stepping]") {
    CHECK_THROWS_WITH(interpolate(1, 2, 1.5), "fraction: 1.5 is not within 0 to 1");
    CHECK_THROWS_WITH(interpolate(Vec2(0, 0), Vec2(1, 1), -0.1), "fraction: -0.1 is not within 0 to 1");
    CHECK_THROWS_WITH(interpolateAngle(1, 2, NAN), "fraction: nan is not finite");
}
