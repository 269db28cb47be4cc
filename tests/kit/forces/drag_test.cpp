// SPDX-License-Identifier: MIT
#include <plumb/forces/drag.h>

#include <cmath>
#include <iostream>
#include <limits>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "kit/forces/runge_kutta.h"

using namespace plumb;

namespace {

double logUniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

}  // namespace

// Worked numbers of response, terminal speed (textbook: v = v_t tanh(g t / v_t)), and of quadratic drag c =
// 0.005 per kg.
TEST_CASE("what falls from rest is at 25.748172225 m/s after 3 s, and 41.234527650 m down", "[forces][facts][law]") {
    const Drag drag{.quadratic = 0.005};
    const auto rate = [&drag](const test::State<4>& s) -> test::State<4> {
        const Vec2 velocity(s[2], s[3]);
        const Vec2 acceleration = Vec2(0, -9.81) + dragForce(drag, velocity);
        return {velocity.x(), velocity.y(), acceleration.x(), acceleration.y()};
    };
    // 1,000 steps of 3 ms: (g h / v_t)^4 = 2e-13, times rounding's 1e-13.
    const test::State<4> fallen = test::integrated<4>(test::State<4>::Zero(), 3, 1000, rate);
    CHECK(std::fabs(fallen[3] + 25.748172225) < 0.6e-9);  // nine decimals, as the next
    CHECK(std::fabs(fallen[1] + 41.234527650) < 0.6e-9);
    CHECK(std::fabs(terminalSpeed(drag, 9.81) - 44.294469181) < 0.6e-9);
    CHECK(std::fabs(-test::integrated<4>(test::State<4>::Zero(), 100, 10'000, rate)[3] - 44.294469181) < 0.6e-9);
}

// Worked numbers of the firing solution, quadratic drag: thrown up at 50 m/s.
TEST_CASE("what is thrown up at 50 m/s turns after 3.8191317573 s at 82.163273487 m, and is back at 33.155434439 m/s",
          "[forces][facts][law]") {
    const Drag drag{.quadratic = 0.005};
    const auto rate = [&drag](const test::State<4>& s) -> test::State<4> {
        const Vec2 velocity(s[2], s[3]);
        const Vec2 acceleration = Vec2(0, -9.81) + dragForce(drag, velocity);
        return {velocity.x(), velocity.y(), acceleration.x(), acceleration.y()};
    };
    const test::State<4> top = test::integrated<4>(test::State<4>(0, 0, 0, 50), 3.8191317573, 4000, rate);
    CHECK(std::fabs(top[3]) < 1e-9);  // the time's last decimal at 9.81 m/s^2
    CHECK(std::fabs(top[1] - 82.163273487) < 0.6e-9);
    const test::State<4> back = test::integrated<4>(top, 4.3779184523, 4000, rate);
    CHECK(std::fabs(back[1]) < 4e-9);  // the time's last decimal at 33 m/s
    CHECK(std::fabs(back[3] + 33.155434439) < 1e-9);
}

TEST_CASE("a ball of 0.1 m that falls at 1.2 kg/m^3 and C = 0.5 ends at sqrt(2 m g / (rho C A))", "[forces][law]") {
    const double area = 3.141592653589793 * 0.01, mass = 2;
    const Drag drag{.quadratic = quadraticDrag(1.2, 0.5, area)};
    CHECK(std::fabs(terminalSpeed(drag, mass * 9.81) - std::sqrt(2 * mass * 9.81 / (1.2 * 0.5 * area))) < 1e-13);
}

TEST_CASE("a bead in oil ends at F / k", "[forces][law]") {
    CHECK(terminalSpeed({.linear = 4}, 2) == 0.5);
    CHECK(terminalSpeed({}, 2) == std::numeric_limits<double>::infinity());
    CHECK(terminalSpeed({}, 0) == 0);
}

TEST_CASE("at its terminal speed nothing speeds up or slows down, 100,000 times", "[forces][law]") {
    Random random(11);
    double worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const Drag drag{.linear = logUniform(random, 1e-6, 1e3), .quadratic = logUniform(random, 1e-6, 1e3)};
        const double force = logUniform(random, 1e-6, 1e6);
        const double speed = terminalSpeed(drag, force);
        worst = std::max(worst, std::fabs(dragForce(drag, {-speed, 0}).x() / force - 1));
    }
    std::cout << "forces: drag at the terminal speed is off by at most " << worst << " of the force\n";
    CHECK(worst < 10 * 1.1e-16);  // some ten roundings, all of numbers of one sign
}

TEST_CASE("drag's closed form is where 100,000 fine integrations come out", "[forces][law]") {
    Random random(12);
    double worst = 0;
    int place = -1;
    const int places = test::cases(100'000);
    for (int i = 0; i < places; ++i) {
        const double mass = logUniform(random, 0.1, 10), time = logUniform(random, 0.01, 10);
        const Vec2 velocity{random.uniform(-10, 10), random.uniform(-10, 10)};
        const Vec2 wind{random.uniform(-10, 10), random.uniform(-10, 10)};
        // Rates of up to 3 / s of each kind, or none, whatever the mass.
        const double linear = random.integer(0, 3) == 0 ? 0 : mass * random.uniform(0, 3);
        const double quadratic = random.integer(0, 3) == 0 ? 0 : mass * random.uniform(0, 3) / (velocity - wind).norm();
        const Drag drag{linear, quadratic, wind};
        const auto rate = [&](const test::State<2>& v) -> test::State<2> { return dragForce(drag, v) / mass; };
        // At most 0.06 of a decay a step: (0.06)^5 / 120 a step, of which all but the first ten have little left.
        const int steps = 10 + static_cast<int>(time * 100);
        const Vec2 stepped = test::integrated<2>(velocity, time, steps, rate);
        const Vec2 closed = velocityAfterDrag(drag, mass, velocity, time);
        const double error = (stepped - closed).norm() / (velocity - wind).norm();
        if (!(error <= worst)) worst = error, place = i;
    }
    std::cout << "forces: drag's closed form is off by at most " << worst << " of the speed (place " << place << " of "
              << places << ")\n";
    CHECK(worst < 1e-7);
}

TEST_CASE("drag for a time at once is as for its parts, 100,000 times", "[forces][law]") {
    Random random(13);
    double worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const Drag drag{logUniform(random, 1e-9, 1e3), logUniform(random, 1e-9, 1e3), {3, -2}};
        const double first = logUniform(random, 1e-6, 10), second = logUniform(random, 1e-6, 10);
        const Vec2 velocity{random.uniform(-100, 100), random.uniform(-100, 100)};
        const Vec2 once = velocityAfterDrag(drag, 1, velocity, first + second);
        const Vec2 twice = velocityAfterDrag(drag, 1, velocityAfterDrag(drag, 1, velocity, first), second);
        worst = std::max(worst, (once - twice).norm() / velocity.norm());
    }
    CHECK(worst < 1e-13);  // exponents up to 700 that are rounded to 1.1e-16
}

TEST_CASE("no drag, however strong, turns a thing back, and all of it makes it go with the wind", "[forces]") {
    CHECK(velocityAfterDrag({}, 1, Vec2(3, 4), 100) == Vec2(3, 4));
    CHECK(velocityAfterDrag({.linear = 1e300}, 1, Vec2(3, 4), 1) == Vec2(0, 0));
    CHECK(velocityAfterDrag({.linear = 1e300, .wind = {-2, 1}}, 1, Vec2(3, 4), 1) == Vec2(-2, 1));
    CHECK(velocityAfterDrag({.quadratic = 1e300}, 1, Vec2(3, 4), 1).norm() < 1e-299);
    CHECK(velocityAfterDrag({.quadratic = 1}, 1, Vec2(3, 4), 0) == Vec2(3, 4));
    CHECK((velocityAfterDrag({.quadratic = 0.2}, 1, Vec2(3, 4), 1) - Vec2(1.5, 2)).norm() < 1e-15);  // 1 / (1 + 1)
    CHECK(dragForce({.linear = 3, .quadratic = 3, .wind = {5, 1}}, Vec2(5, 1)) == Vec2(0, 0));
}

TEST_CASE("drag that pushes is refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(dragForce({.linear = -1}, Vec2(0, 0)), "Drag.linear: -1 is negative");
    CHECK_THROWS_WITH(terminalSpeed({.quadratic = std::nan("")}, 1), "Drag.quadratic: nan is not finite");
    CHECK_THROWS_WITH(velocityAfterDrag({}, 0, Vec2(0, 0), 1), "velocityAfterDrag: mass: 0 is not positive");
    CHECK_THROWS_WITH(velocityAfterDrag({}, 1, Vec2(0, 0), -1), "velocityAfterDrag: time: -1 is negative");
    CHECK_THROWS_WITH(quadraticDrag(1, -1, 1), "quadraticDrag: dragCoefficient: -1 is negative");
}
