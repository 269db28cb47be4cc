// SPDX-License-Identifier: MIT
#include <plumb/kinematics/linear_drag.h>

#include <plumb/integrate/fixed_step.h>
#include <plumb/kinematics/constant_acceleration.h>
#include <plumb/math/random.h>

#include <cmath>
#include <iostream>
#include <limits>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

using Long = long double;

double ulps(double found, Long truth) {
    const double size = std::fabs(static_cast<double>(truth));
    const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
    return static_cast<double>(std::fabs(found - truth)) / ulp;
}

// Below 1/8 the first twelve terms of the series, whose next is below 1e-22; above, x - 1 + e^-x loses 8 bits of
// 64.
Long reachOf(Long k, Long t) {
    const Long x = k * t;
    if (x > 0.125L) return (x + std::expm1(-x)) / k / k;
    Long term = t * t / 2, sum = 0;
    for (int n = 3; n < 16; ++n) {
        sum += term;
        term *= -x / n;
    }
    return sum;
}

}  // namespace

TEST_CASE("keep, gain and reach are those of long double, for k t from 1e-20 to 1e3", "[kinematics]") {
    Random random(11);
    double worst = 0, at = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double time = std::exp2(random.uniform(-10, 10)), x = std::exp2(random.uniform(-66, 10));
        const double drag = x / time;
        const DragStep step = dragStep(drag, time);
        const Long exact = static_cast<Long>(drag) * time;
        // a product rounded at x changes e^-x by x of its last place: that much is not the step's to know
        const double keep = ulps(step.keep, std::exp(-exact)) - x;
        const double gain = ulps(step.gain, -std::expm1(-exact) / drag), reach = ulps(step.reach, reachOf(drag, time));
        const double off = std::max({keep, gain, reach});
        if (off > worst) at = x;
        worst = std::max(worst, off);
    }
    std::cout << "kinematics, drag step: worst " << worst << " ulp, at k t = " << at << '\n';
    CHECK(worst <= 4);
}

TEST_CASE("without drag, and with a drag of 1e-300 or 5e-324, a step is that of constant acceleration",
          "[kinematics]") {
    for (const double drag : {0.0, 5e-324, 1e-300, 1e-20}) {
        const DragStep step = dragStep(drag, 3);
        CHECK(step.keep == 1);
        CHECK(step.gain == 3);
        CHECK(step.reach == 4.5);
    }
    const PointMotion from{{1, 2}, {3, 4}};
    const PointMotion drag = moveWithDrag(from, {.wind = {9, 9}, .acceleration = {0, -9.81}}, 1.5);
    const PointMotion none = moveAccelerated(from, {0, -9.81}, 1.5);
    CHECK((drag.position - none.position).norm() < 1e-14);
    CHECK((drag.velocity - none.velocity).norm() < 1e-14);
}

// Worked numbers of the firing solution: k = 0.2, 45 degrees, 20 m/s: T, R and apex; and with wind -5 the same T and
// another R.
TEST_CASE("a shot of 20 m/s at 45 degrees with drag 0.2 flies 29.091533064 m, against a wind of 5 m/s 26.126035300 m",
          "[kinematics][facts]") {
    const PointMotion shot{{0, 0}, {20 * std::sqrt(0.5), 20 * std::sqrt(0.5)}};
    const DragLaw air{.rate = 0.2, .acceleration = {0, -9.81}};
    const PointMotion down = moveWithDrag(shot, air, 2.6501815833);
    CHECK(std::fabs(down.position.x() - 29.091533064) < 1e-9);
    CHECK(std::fabs(down.position.y()) < 11 * 1e-10);  // it falls at 11 m/s, and T has ten digits behind the point
    const PointMotion apex = moveWithDrag(shot, air, 1.2666983553);
    CHECK(std::fabs(apex.position.y() - 8.5791237899) < 1e-10);
    CHECK(std::fabs(apex.velocity.y()) < 10 * 1e-10);
    const PointMotion windy =
        moveWithDrag(shot, {.rate = 0.2, .wind = {-5, 0}, .acceleration = {0, -9.81}}, 2.6501815833);
    CHECK(std::fabs(windy.position.x() - 26.126035300) < 1e-9);
}

// Runge-Kutta of 400 steps: (k h)^5 / 120 of the motion a step, so below 400 * 2e-11 / 120 at k h = 3 * 3 / 400.
TEST_CASE("a point in wind and drag is where a fine Runge-Kutta takes it", "[kinematics]") {
    Random random(13);
    double worst = 0;
    for (int i = 0; i < cases(2000); ++i) {
        const auto vector = [&](double most) { return Vec2(random.uniform(-most, most), random.uniform(-most, most)); };
        const DragLaw law{random.uniform(0, 3), vector(10), vector(10)};
        const PointMotion from{vector(10), vector(30)};
        const double time = random.uniform(0, 3);
        Eigen::Vector4d state(from.position.x(), from.position.y(), from.velocity.x(), from.velocity.y());
        const auto slope = [&](double, const Eigen::Vector4d& y) -> Eigen::Vector4d {
            const Vec2 velocity = y.tail<2>(), pull = law.acceleration - law.rate * (velocity - law.wind);
            return {velocity.x(), velocity.y(), pull.x(), pull.y()};
        };
        for (int step = 0; step < 400; ++step) state = rungeKutta4Step(slope, step * time / 400, state, time / 400);
        const PointMotion to = moveWithDrag(from, law, time);
        worst = std::max({worst, (to.position - state.head<2>()).norm(), (to.velocity - state.tail<2>()).norm()});
    }
    std::cout << "kinematics, drag against Runge-Kutta: worst " << worst << " m or m/s\n";
    CHECK(worst < 50 * 7e-11);
}

TEST_CASE("60 steps with drag lead where one step does", "[kinematics]") {
    const DragLaw law{0.7, {3, -1}, {0, -9.81}};
    PointMotion point{{1, 2}, {30, 20}};
    const PointMotion atOnce = moveWithDrag(point, law, 3);
    for (int i = 0; i < 60; ++i) point = moveWithDrag(point, law, 0.05);
    CHECK((point.position - atOnce.position).norm() < 60 * 4 * 4e-15);
    CHECK((point.velocity - atOnce.velocity).norm() < 60 * 4 * 4e-15);
}

TEST_CASE("the largest drag stops a point in the wind at once, and a negative one is refused", "[kinematics]") {
    const PointMotion still = moveWithDrag({{1, 2}, {30, 20}}, {.rate = 1e300, .wind = {2, 0}}, 3);
    CHECK(still.position == Vec2(7, 2));
    CHECK(still.velocity == Vec2(2, 0));
    CHECK_THROWS_WITH(moveWithDrag({}, {.rate = -1}, 1), "DragLaw.rate: -1 is negative");
    CHECK_THROWS_WITH(moveWithDrag({}, {.wind = {0, NAN}}, 1), "DragLaw.wind: (0, nan) is not finite");
    CHECK_THROWS_WITH(moveWithDrag({}, {}, -1), "time: -1 is negative");
    CHECK_THROWS_WITH(dragStep(INFINITY, 1), "rate: inf is not finite");
}
