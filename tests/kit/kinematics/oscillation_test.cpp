// SPDX-License-Identifier: MIT
#include <plumb/kinematics/oscillation.h>

#include <plumb/math/random.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

using Long = long double;
using Matrix = std::array<Long, 4>;  ///< of (x, v / w), row by row

Matrix product(const Matrix& a, const Matrix& b) {
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}

/// e^(A theta) for A = (0 1; -1 -2z): Taylor's series of a short step, squared until it is the whole. It knows of
/// no swinging or creeping. Source: Moler and Van Loan, "Nineteen dubious ways", 1978, method 3.
Matrix exponentialOf(Long z, Long theta) {
    int halvings = 0;
    for (; theta * (1 + 2 * z) > 0.5L; theta /= 2) ++halvings;
    const Matrix step{0, theta, -theta, -2 * z * theta};
    Matrix term{1, 0, 0, 1}, sum{1, 0, 0, 1};
    for (int n = 1; n < 18; ++n) {
        term = product(term, step);
        for (std::size_t i = 0; i < 4; ++i) {
            term[i] /= n;
            sum[i] += term[i];
        }
    }
    for (; halvings > 0; --halvings) sum = product(sum, sum);
    return sum;
}

double randomDamping(Random& random) {
    switch (random.integer(0, 4)) {
        case 0: return 0;
        case 1: return random.uniform(0, 1);
        case 2: return random.uniform(1, 10);
        case 3: return 1 + random.uniform(-1, 1) * std::exp2(random.uniform(-60, 0));
        default: return 1;
    }
}

/// The largest difference of any part, in units of x and v / w.
double distance(const OscillatorStep& a, const OscillatorStep& b, double w) {
    return std::max(
        {std::fabs(a.xx - b.xx), w * std::fabs(a.xv - b.xv), std::fabs(a.vx - b.vx) / w, std::fabs(a.vv - b.vv)});
}

}  // namespace

// All parts are at most 1 in size. A rounding of theta = w t, and of the root times it, moves them by theta (1 +
// 2 z) of the last place; four operations add theirs.
TEST_CASE("an oscillator of any damping is where the matrix exponential takes it, 1,000,000 times", "[kinematics]") {
    Random random(17);
    double worst = 0, atZ = 0, atTheta = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double w = std::exp2(random.uniform(-5, 5)), z = randomDamping(random);
        const double time = std::exp2(random.uniform(-12, 6)) / w;
        const OscillatorStep step = oscillatorStep({w, z}, time);
        const Long theta = static_cast<Long>(w) * time;
        const Matrix truth = exponentialOf(z, theta);
        const OscillatorStep exact{static_cast<double>(truth[0]), static_cast<double>(truth[1] / w),
                                   static_cast<double>(truth[2] * w), static_cast<double>(truth[3])};
        const double error = distance(step, exact, w) / (4 + static_cast<double>(theta) * (1 + 2 * z)) * 0x1p53;
        if (error > worst) {
            worst = error;
            atZ = z;
            atTheta = static_cast<double>(theta);
        }
    }
    std::cout << "kinematics, oscillator: worst " << worst << " roundings, at z " << atZ << ", w t " << atTheta << '\n';
    CHECK(worst <= 1.5);
}

// The true parts change by at most 2 theta times a change of z; the rest is what both round, as above.
TEST_CASE("an oscillator is smooth across critical damping, and where its series ends", "[kinematics]") {
    for (const double time : {1e-3, 0.1, 1.0, 3.0, 10.0}) {
        for (const double change : {1e-16, 1e-15, 1e-14, 1e-12}) {
            const OscillatorStep below = oscillatorStep({1, 1 - change}, time),
                                 above = oscillatorStep({1, 1 + change}, time);
            const double allowed = 2 * change * time + 2 * 1.5 * 0x1p-53 * (4 + 3 * time);
            CHECK(distance(below, oscillatorStep({1, 1}, time), 1) < allowed);
            CHECK(distance(above, oscillatorStep({1, 1}, time), 1) < allowed);
        }
    }
    for (const double z : {0.0, 0.6, 1.25, 5.0}) {
        const double seam = 1 / std::sqrt(std::fabs(1 - z * z));
        CHECK(distance(oscillatorStep({1, z}, seam * (1 - 1e-15)), oscillatorStep({1, z}, seam * (1 + 1e-15)), 1) <
              1e-14 * (1 + z));
    }
}

// Worked numbers of response, Spring: m 1, k 4, c 0.4, from 1 m at rest.
TEST_CASE("a spring of 4 N/m and 0.4 N s/m takes 1 kg from 1 m to -0.2580702634 m in 1 s, its period is 3.1574194170 s",
          "[kinematics][facts]") {
    const Oscillator spring = oscillatorOf(1, 4, 0.4);
    CHECK(std::fabs(oscillate(AxisMotion{1, 0}, 0, spring, 1).position + 0.2580702634) < 5e-11);
    REQUIRE(dampedPeriod(spring));
    CHECK(std::fabs(*dampedPeriod(spring) - 3.1574194170) < 5e-11);
    CHECK_FALSE(dampedPeriod({2, 1}));
    CHECK_FALSE(dampedPeriod({0, 0}));
}

TEST_CASE("simple harmonic motion is what the exact step makes of it", "[kinematics]") {
    Random random(19);
    double worst = 0;
    for (int i = 0; i < 10'000; ++i) {
        const HarmonicMotion motion{random.uniform(-2, 2), random.uniform(0, 5), random.uniform(-3, 3)};
        const double start = random.uniform(0, 5), time = random.uniform(0, 5);
        const AxisMotion to = oscillate(harmonicAt(motion, start), 0, {motion.angularFrequency, 0}, time);
        const AxisMotion truth = harmonicAt(motion, start + time);
        worst = std::max({worst, std::fabs(to.position - truth.position), std::fabs(to.velocity - truth.velocity)});
    }
    CHECK(worst < 2 * 5 * 50 * 2e-16);  // amplitude, frequency, and angles of 50 rad rounded
}

// The same parts each time, whose determinant is 1 to 2e-16 or so: 100,000 times that, twice for the square.
TEST_CASE("100,000 steps of an undamped oscillator keep its energy to 4e-11, and a damped one only loses",
          "[kinematics]") {
    AxisMotion swing{1, 0};
    for (int i = 0; i < 100'000; ++i) swing = oscillate(swing, 0, {3, 0}, 0.1);
    CHECK(std::fabs(swing.velocity * swing.velocity + 9 * swing.position * swing.position - 9) < 9 * 4e-11);

    Random random(23);
    int gains = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Oscillator spring{random.uniform(0.1, 5), randomDamping(random)};
        const double w2 = spring.angularFrequency * spring.angularFrequency;
        const AxisMotion from{random.uniform(-1, 1), random.uniform(-1, 1)};
        const AxisMotion to = oscillate(from, 0, spring, random.uniform(0, 10));
        const double before = from.velocity * from.velocity + w2 * from.position * from.position;
        gains += to.velocity * to.velocity + w2 * to.position * to.position > before * (1 + 1e-13);
    }
    CHECK(gains == 0);
}

TEST_CASE("two steps of an oscillator are one of both times, and a plane is its axes", "[kinematics]") {
    Random random(29);
    double worst = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Oscillator spring{random.uniform(0.1, 3), randomDamping(random)};
        const double one = random.uniform(0, 5), other = random.uniform(0, 5);
        const PointMotion from{{random.uniform(-1, 1), 2}, {random.uniform(-1, 1), 0}};
        const PointMotion twice = oscillate(oscillate(from, {0, 1}, spring, one), {0, 1}, spring, other);
        const PointMotion once = oscillate(from, {0, 1}, spring, one + other);
        const AxisMotion x = oscillate(AxisMotion{from.position.x(), from.velocity.x()}, 0, spring, one + other);
        worst = std::max({worst, (twice.position - once.position).norm(), (twice.velocity - once.velocity).norm()});
        CHECK(once.position.x() == x.position);
        CHECK(once.velocity.x() == x.velocity);
    }
    CHECK(worst < 1e-13);  // angles of 30 rad rounded, of motions of 10
}

TEST_CASE("without a spring nothing pulls, and at the largest damping nothing moves", "[kinematics]") {
    CHECK(oscillate(AxisMotion{1, 2}, 0, {0, 0.5}, 3).position == 7);
    CHECK(std::fabs(oscillate(AxisMotion{1, 0}, 0, {1, 1e300}, 3).position - 1) < 1e-15);
    CHECK(std::fabs(oscillate(AxisMotion{1, 0}, 0, {1, 1e300}, 3).velocity) < 1e-300);
    CHECK(oscillate(AxisMotion{1, 5}, 0, {1e150, 1}, 1e150).position == 0);
    CHECK_THROWS_WITH(oscillatorStep({-1, 0}, 1), "Oscillator.angularFrequency: -1 is negative");
    CHECK_THROWS_WITH(oscillatorStep({1, -0.1}, 1), "Oscillator.dampingRatio: -0.1 is negative");
    CHECK_THROWS_WITH(oscillatorStep({1, 0}, NAN), "time: nan is not finite");
    CHECK_THROWS_WITH(oscillatorStep({1e200, 0}, 1e200), "Oscillator.angularFrequency * time: inf is not finite");
    CHECK_THROWS_WITH(oscillatorOf(0, 1, 1), "mass: 0 is not positive");
    CHECK_THROWS_WITH(harmonicAt({.phase = NAN}, 1), "HarmonicMotion.phase: nan is not finite");
    CHECK_THROWS_WITH(harmonicAt({.angularFrequency = 1e308, .phase = 1e308}, 1),
                      "HarmonicMotion.angularFrequency * time + phase: inf is not finite");
    CHECK_THROWS_WITH(harmonicAt({.amplitude = 1e200, .angularFrequency = 1e200}, 1),
                      "HarmonicMotion.amplitude * angularFrequency: inf is not finite");
}
