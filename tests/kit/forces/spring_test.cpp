// SPDX-License-Identifier: MIT
#include <plumb/forces/spring.h>

#include <cmath>

#include "catch.h"
#include "kit/forces/runge_kutta.h"

using namespace plumb;

namespace {

/// A mass on a spring to an anchor: place, velocity, and the heat of the damper.
test::State<5> swung(const SpringDamper& spring, double mass, const Vec2& anchor, const test::State<5>& start,
                     double time, int steps) {
    return test::integrated<5>(start, time, steps, [&](const test::State<5>& s) -> test::State<5> {
        const SpringEnd fixed{anchor, {0, 0}}, end{s.segment<2>(0), s.segment<2>(2)};
        test::State<5> rate;
        rate << s.segment<2>(2), springForce(spring, fixed, end) / mass, dampingPower(spring, fixed, end);
        return rate;
    });
}

}  // namespace

// Worked numbers of response, spring (zeta = c / (2 sqrt(k m))): 1 kg, 4 N/m, 0.4 N s/m, let go at 1 m.
TEST_CASE("a mass of 1 kg on 4 N/m with 0.4 N s/m is at -0.2580702634 m after 1 s", "[forces][facts][law]") {
    const SpringDamper spring{.stiffness = 4, .damping = 0.4, .restLength = 3};
    test::State<5> start;
    start << 4, 0, 0, 0, 0;
    CHECK(std::fabs(swung(spring, 1, {0, 0}, start, 1, 1000)[0] - 3 + 0.2580702634) < 0.6e-10);
    // A whole period on it turns back again, smaller by e^(-0.2 T).
    const test::State<5> turned = swung(spring, 1, {0, 0}, start, 3.1574194170, 4000);
    CHECK(std::fabs(turned[2]) < 4 * 0.6e-10);  // the period's last decimal, at up to 4 m/s^2
    CHECK(std::fabs(turned[0] - 3 - std::exp(-0.2 * 3.1574194170)) < 0.6e-10);
}

TEST_CASE("a mass on a spring is back after 2 pi sqrt(m / k)", "[forces][law]") {
    // Without a rest length it swings on an ellipse, in one period whatever its shape.
    test::State<5> start;
    start << 2.5, 2, 1, 3, 0;
    const test::State<5> end = swung({.stiffness = 9}, 4, {1, 2}, start, 2 * 3.141592653589793 * 2 / 3, 2000);
    CHECK((end - start).norm() < 1e-10);  // (2 pi / 2000)^4 / 120 * 2 pi
}

TEST_CASE("what a damper turns into heat is what the swing loses", "[forces][law]") {
    const SpringDamper spring{.stiffness = 20, .damping = 1.5, .restLength = 1};
    const auto energy = [&spring](const test::State<5>& s) -> double {
        return 2 * s.segment<2>(2).squaredNorm() / 2 + potentialEnergy(spring, {0, 0}, s.segment<2>(0));
    };
    test::State<5> start;
    start << 2, 0, 1, 2, 0;
    const test::State<5> end = swung(spring, 2, {0, 0}, start, 3, 3000);
    CHECK(end[4] > 1);
    CHECK(std::fabs(energy(start) - energy(end) - end[4]) < 1e-10);
}

TEST_CASE("a spring pushes where it is short and pulls where it is long", "[forces][law]") {
    const SpringDamper spring{.stiffness = 10, .damping = 3, .restLength = 2};
    CHECK(springForce(spring, {}, {{1, 0}, {0, 0}}) == Vec2(10, 0));
    CHECK(springForce(spring, {}, {{0, 3}, {0, 0}}) == Vec2(0, -10));
    CHECK(springForce(spring, {{0, 0}, {0, 0}}, {{0, 2}, {5, 2}}) == Vec2(0, -6));  // across it, no damper
    CHECK(springForce(spring, {{0, 0}, {5, 2}}, {{0, 2}, {5, 2}}) == Vec2(0, 0));
    CHECK(potentialEnergy(spring, {0, 0}, {0, 3}) == 5);
}

TEST_CASE("a spring of no length has no direction, and no NaN", "[forces]") {
    const SpringDamper spring{.damping = 3, .restLength = 2};
    CHECK(springForce(spring, {{1, 1}, {0, 0}}, {{1, 1}, {3, 4}}) == Vec2(0, 0));
    CHECK(dampingPower(spring, {{1, 1}, {0, 0}}, {{1, 1}, {3, 4}}) == 0);
    CHECK(potentialEnergy(spring, {1, 1}, {1, 1}) == 200);
    const Vec2 close = springForce(spring, {}, {{0, 1e-160}, {0, 0}});
    CHECK(std::fabs(close.y() - 200) < 0.03);  // its square, 2024 of the least numbers, is rounded to a whole one
}

TEST_CASE("springs that gain energy are refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(springForce({.stiffness = -1}, {}, {}), "SpringDamper.stiffness: -1 is negative");
    CHECK_THROWS_WITH(springForce({.damping = -1}, {}, {}), "SpringDamper.damping: -1 is negative");
    CHECK_THROWS_WITH(potentialEnergy(SpringDamper{.restLength = -1}, {0, 0}, {0, 0}),
                      "SpringDamper.restLength: -1 is negative");
}
