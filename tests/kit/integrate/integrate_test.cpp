// SPDX-License-Identifier: MIT
#include <plumb/integrate/integrate.h>

#include <plumb/math/random.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "cases.h"
#include "catch.h"
#include "kit/integrate/oscillator.h"

namespace {

using namespace plumb;
using namespace plumb::test;
using std::numbers::pi;
using Vector4 = Eigen::Vector4d;

double first(double, const Vector2& y) {
    return y[0];
}
double second(double, const Vector2& y) {
    return y[1];
}

}  // namespace

// Dormand-Prince and its interpolant are exact on a parabola: what is left are roundings of the height, some four
// of the last place a step for 30 steps at most, over the speed it comes down at; and of the time.
TEST_CASE("the time at which a thrown ball comes down is the closed form's, 1,000,000 times", "[integrate]") {
    Random random(67);
    double worst = 0;
    int missed = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double height = i % 2 ? random.uniform(0, 20) : 0, up = random.uniform(0.1, 40);
        const auto falls = [](double, const Vector2& y) -> Vector2 { return {y[1], -9.81}; };
        const Integration<Vector2> down =
            integrateUntil(falls, 0, Vector2(height, up), 100, first, ZeroCrossing::Falling);
        const double speed = std::sqrt(up * up + 2 * 9.81 * height), truth = (up + speed) / 9.81;
        missed += down.end != IntegrationEnd::Crossed;
        const double top = height + up * up / (2 * 9.81);
        const double rounding = 0x1p-53 * ((top + speed * truth) / speed + truth);
        worst = std::max(worst, std::fabs(down.time - truth) / rounding);
    }
    std::cout << "integrate, a ball comes down: worst " << worst << " roundings\n";
    CHECK(missed == 0);
    CHECK(worst < 30);
}

TEST_CASE("an oscillator's first zero is found within the tolerance, whatever its phase", "[integrate]") {
    Random random(71);
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
        double worst = 0;
        for (int i = 0; i < 500; ++i) {
            const double phase = random.uniform(-pi / 2 + 0.01, pi / 2 - 0.01);
            const Integration<Vector2> zero =
                integrateUntil(oscillator, 0, Vector2(std::cos(phase), -std::sin(phase)), 10, first,
                               ZeroCrossing::Either, {.absoluteTolerance = tolerance, .relativeTolerance = tolerance});
            worst = std::max(worst, std::fabs(zero.time - (pi / 2 - phase)));
            CHECK(std::fabs(zero.state[0]) < 2e-16);
        }
        std::cout << "integrate, an oscillator's zero at tolerance " << tolerance << ": worst " << worst << " s\n";
        CHECK(worst < 10 * tolerance);  // up to 100 steps, each off by a tenth of it at most
    }
}

TEST_CASE("a crossing counts in the direction asked for, and a start on zero does not", "[integrate]") {
    const Vector2 start(1, 0);  // cosine; its slope starts on zero and goes down
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, 20, first, ZeroCrossing::Falling).time - pi / 2) < 1e-8);
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, 20, first, ZeroCrossing::Rising).time - 1.5 * pi) < 1e-8);
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, 20, second).time - pi) < 1e-8);
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, 20, second, ZeroCrossing::Falling).time - 2 * pi) < 1e-8);
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, -20, first).time + pi / 2) < 1e-8);  // back in time
    const auto clock = [](double t, const Vector2&) { return t - 3; };
    CHECK(std::fabs(integrateUntil(oscillator, 0, start, 20, clock).time - 3) < 1e-15);
}

TEST_CASE("without a crossing an integration reaches its end", "[integrate]") {
    const auto never = [](double, const Vector2& y) { return y[0] + 2; };
    const auto nan = [](double, const Vector2&) { return NAN; };
    const Integration<Vector2> plain = integrate(oscillator, 0, Vector2(1, 0), 20);
    for (const Integration<Vector2>& found : {integrateUntil(oscillator, 0, Vector2(1, 0), 20, never),
                                              integrateUntil(oscillator, 0, Vector2(1, 0), 20, nan)}) {
        CHECK(found.end == IntegrationEnd::Reached);
        CHECK(found.time == 20);
        CHECK(found.state == plain.state);
    }
}

TEST_CASE("what is below zero for 0.02 s only is found with a longest step of 0.1 s", "[integrate]") {
    const auto dip = [](double, const Vector2& y) { return y[0] + 0.99995; };  // cosine, near pi
    const Integration<Vector2> found =
        integrateUntil(oscillator, 0, Vector2(1, 0), 20, dip, ZeroCrossing::Either, {.maxStep = 0.1});
    CHECK(found.end == IntegrationEnd::Crossed);
    CHECK(std::fabs(found.time - std::acos(-0.99995)) < 1e-6);  // the slope there is 0.01: 1e-9 over it, ten times
}

// Worked numbers of the firing solution: c = 0.005, up 50: t_up, H, speed of return, t_down. All by integration; the
// tolerance is 1e-12.
TEST_CASE(
    "50 m/s up against quadratic drag of 0.005 rises 82.163273487 m in 3.8191317573 s and returns at 33.155434439",
    "[integrate][facts]") {
    const auto drag = [](double, const Vector2& y) -> Vector2 {
        return {y[1], -9.81 - 0.005 * y[1] * std::fabs(y[1])};
    };
    const AdaptiveSettings exact{.absoluteTolerance = 1e-12, .relativeTolerance = 1e-12};
    const Integration<Vector2> top = integrateUntil(drag, 0, Vector2(0, 50), 20, second, ZeroCrossing::Either, exact);
    CHECK(std::fabs(top.time - 3.8191317573) < 1e-10);
    CHECK(std::fabs(top.state[0] - 82.163273487) < 1e-9);
    const Integration<Vector2> down =
        integrateUntil(drag, top.time, top.state, 20, first, ZeroCrossing::Falling, exact);
    CHECK(std::fabs(down.state[1] + 33.155434439) < 1e-9);
    CHECK(std::fabs(down.time - top.time - 4.3779184523) < 1e-10);
}

// Worked numbers of the firing solution: k = 0.2, 45 degrees, v = 20: T, R and the apex.
TEST_CASE("20 m/s at 45 degrees against linear drag of 0.2 comes down after 2.6501815833 s at 29.091533064 m",
          "[integrate][facts]") {
    const auto drag = [](double, const Vector4& y) -> Vector4 { return {y[2], y[3], -0.2 * y[2], -9.81 - 0.2 * y[3]}; };
    const AdaptiveSettings exact{.absoluteTolerance = 1e-12, .relativeTolerance = 1e-12};
    const double part = 20 * std::sqrt(0.5);
    const Vector4 shot(0, 0, part, part);
    const auto height = [](double, const Vector4& y) { return y[1]; };
    const auto climb = [](double, const Vector4& y) { return y[3]; };
    const Integration<Vector4> down = integrateUntil(drag, 0, shot, 20, height, ZeroCrossing::Falling, exact);
    CHECK(std::fabs(down.time - 2.6501815833) < 1e-10);
    CHECK(std::fabs(down.state[0] - 29.091533064) < 1e-9);
    const Integration<Vector4> apex = integrateUntil(drag, 0, shot, 20, climb, ZeroCrossing::Either, exact);
    CHECK(std::fabs(apex.time - 1.2666983553) < 1e-10);
    CHECK(std::fabs(apex.state[1] - 8.5791237899) < 1e-9);
}
