// SPDX-License-Identifier: MIT
#include <compare/formula/pendulum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

constexpr double pi = std::numbers::pi;

double degrees(double angle) {
    return angle * pi / 180;
}

double smallPeriod(double equivalentLength) {
    return periodOf({.equivalentLength = equivalentLength, .amplitude = 1e-8});  // longer by 4e-18
}

/// theta'' = -(g / L) sin theta, by the classical Runge-Kutta method.
Swing integrated(const Pendulum& pendulum, double t, int steps) {
    using State = std::array<double, 2>;
    const double h = t / steps;
    const auto rate = [&](const State& s) {
        return State{s[1], -pendulum.gravity / pendulum.equivalentLength * std::sin(s[0])};
    };
    const auto shifted = [](const State& s, const State& d, double by) {
        return State{s[0] + by * d[0], s[1] + by * d[1]};
    };
    State s{pendulum.amplitude, 0};
    for (int i = 0; i < steps; ++i) {
        const State a = rate(s);
        const State b = rate(shifted(s, a, h / 2));
        const State c = rate(shifted(s, b, h / 2));
        const State d = rate(shifted(s, c, h));
        for (std::size_t k = 0; k < 2; ++k) s[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return {s[0], s[1]};
}

}  // namespace

TEST_CASE("a pendulum of 1 m swings 2.0060666807 s, and 1.0399733432 times as long at 45 degrees",
          "[compare][formula][facts][law]") {
    // Worked numbers of response, pendulum.
    CHECK(std::abs(smallPeriod(1) - 2.0060666807) < digits);
    const auto factor = [](double angle) { return periodOf({.amplitude = degrees(angle)}) / smallPeriod(1); };
    CHECK(std::abs(factor(45) - 1.0399733432) < digits);
    CHECK(std::abs(factor(90) - 1.1803405990) < digits);
    CHECK(std::abs(factor(150) - 1.7622037295) < digits);
}

TEST_CASE("a rod of 1 m swings 1.6379465859 s about its end, a disc of 1 m 2.4569198789 s about its rim",
          "[compare][formula][facts][law]") {
    // Worked numbers of response, physical pendulum. L = I / (m l): rod (1/3) / (1/2), disc (1/2 + 1) / 1.
    CHECK(std::abs(smallPeriod(2.0 / 3) - 1.6379465859) < digits);
    CHECK(std::abs(smallPeriod(1.5) - 2.4569198789) < digits);
}

TEST_CASE("a pendulum's closed form solves its equation of motion", "[compare][formula][law]") {
    for (const double angle : {1.0, 45.0, 90.0, 150.0, -150.0, 179.0}) {
        const Pendulum pendulum{.equivalentLength = 1.005, .amplitude = degrees(angle)};
        for (const double t : {0.0, 0.1, 0.7, 1.3, 5.0}) {
            const Swing closed = swingAt(pendulum, t);
            const Swing stepped = integrated(pendulum, t, 20000);
            // h = 2.5e-4 s: (w h)^4 = 4e-13 over 16 radians, and 20000 roundings of 1e-16; both grow with sqrt(k) = 1e3
            // where the pendulum lingers at the top, at 179 degrees.
            const double tolerance = std::abs(angle) < 170 ? 1e-10 : 1e-8;
            INFO("amplitude " << angle << " degrees, t = " << t);
            CHECK(std::abs(closed.angle - stepped.angle) < tolerance);
            CHECK(std::abs(closed.angularVelocity - stepped.angularVelocity) < 10 * tolerance);
        }
    }
}

TEST_CASE("a pendulum released at 150 degrees hangs straight down after a quarter period, at 6.0504 rad/s",
          "[compare][formula][law]") {
    const Pendulum pendulum{.amplitude = degrees(150)};
    const double period = periodOf(pendulum);
    const Swing down = swingAt(pendulum, period / 4);
    CHECK(std::abs(down.angle) < 1e-13);
    // Energy: w^2 = 2 (g / L) (1 - cos 150 degrees) = 36.611
    CHECK(std::abs(down.angularVelocity + std::sqrt(2 * 9.81 * (1 + std::sqrt(0.75)))) < 1e-13);
    const Swing other = swingAt(pendulum, period / 2);
    CHECK(std::abs(other.angle + degrees(150)) < 1e-13);
    CHECK(std::abs(other.angularVelocity) < 1e-12);
    // A thousand periods on, the rounding of t = 3535 s is 5e-13 s, at 6 rad/s.
    CHECK(std::abs(swingAt(pendulum, 1000.25 * period).angle) < 1e-11);
}

TEST_CASE("velocity Verlet at 240 Hz is off by 0.07 mm at 45 degrees, 0.03 mm at 150, at 60 Hz by 1.2 mm",
          "[compare][formula]") {
    // What the limits of the pendulum scenes give as their reason: 5 s, 1 m from the hinge.
    const auto worst = [](double angle, double h) {
        const Pendulum pendulum{.equivalentLength = 1.005, .amplitude = degrees(angle)};
        const auto pull = [&](double theta) { return -9.81 / 1.005 * std::sin(theta); };
        double theta = pendulum.amplitude, rate = 0, error = 0;
        for (int i = 1; i * h <= 5; ++i) {
            rate += h / 2 * pull(theta);
            theta += h * rate;
            rate += h / 2 * pull(theta);
            error = std::max(error, std::abs(theta - swingAt(pendulum, i * h).angle));
        }
        return error;
    };
    CHECK(std::abs(worst(45, 1.0 / 240) - 0.07e-3) < 0.005e-3);
    CHECK(std::abs(worst(150, 1.0 / 240) - 0.03e-3) < 0.005e-3);
    CHECK(std::abs(worst(45, 1.0 / 60) - 1.2e-3) < 0.05e-3);
}

TEST_CASE("a pendulum keeps its energy to 1e-14 for 100 s", "[compare][formula][law]") {
    const Pendulum pendulum{.equivalentLength = 0.7, .gravity = 3.7, .amplitude = degrees(150)};
    const auto energy = [&](double t) {
        const Swing s = swingAt(pendulum, t);
        const double lift = (1 - std::cos(s.angle)) * pendulum.gravity / pendulum.equivalentLength;
        return s.angularVelocity * s.angularVelocity / 2 + lift;
    };
    for (int i = 1; i <= 1000; ++i) CHECK(std::abs(energy(0.1 * i) / energy(0) - 1) < 1e-14);
}

TEST_CASE("a pendulum released at 0 degrees hangs still", "[compare][formula]") {
    const Swing still = swingAt({.amplitude = 0}, 3);
    CHECK(still.angle == 0);
    CHECK(still.angularVelocity == 0);
}

}  // namespace plumb::compare
