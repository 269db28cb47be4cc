// SPDX-License-Identifier: MIT
// What is each quantity by the textbook's own formula, in long double, with a bound of what rounding takes there?
#include <plumb/kinematics/constant_acceleration.h>

#include <plumb/math/random.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

using Long = long double;

/// A number and how far it may be from the true one: running error analysis, Higham, "Accuracy and Stability",
/// 3.3.
struct Bounded {
    Long value, error;
    Bounded(Long exact) : value(exact), error(0) {}
    Bounded(Long number, Long before)
        : value(number), error(before + std::fabs(number) * std::numeric_limits<Long>::epsilon()) {}
};
Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value + b.value, a.error + b.error};
}
Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value - b.value, a.error + b.error};
}
Bounded operator*(const Bounded& a, const Bounded& b) {
    return {a.value * b.value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error};
}
Bounded operator/(const Bounded& a, const Bounded& b) {
    const Long least = std::fabs(b.value) - b.error;
    const Long quotient = a.value / b.value;
    return {quotient, (a.error + std::fabs(quotient) * b.error) / std::max(least, Long(0))};
}
Bounded root(const Bounded& a) {
    const Long value = std::sqrt(a.value);
    return {value, a.error / value};
}

/// One solution by the textbook, of random knowns; found's counterpart.
struct Case {
    KnownMotion known;
    std::vector<std::pair<double SolvedMotion::*, Bounded>> truth;
};

// d, u, v, a, t below are random doubles; of each case three are known.
std::vector<Case> casesOf(double D, double U, double V, double A, double T) {
    const Bounded d(D), u(U), v(V), a(A), t(T), two(2);
    const auto dOf = &SolvedMotion::displacement;
    const auto uOf = &SolvedMotion::startVelocity, vOf = &SolvedMotion::endVelocity;
    const auto aOf = &SolvedMotion::acceleration, tOf = &SolvedMotion::time;
    return {
        {{.startVelocity = U, .acceleration = A, .time = T}, {{vOf, u + a * t}, {dOf, u * t + a * t * t / two}}},
        {{.endVelocity = V, .acceleration = A, .time = T}, {{uOf, v - a * t}, {dOf, v * t - a * t * t / two}}},
        {{.startVelocity = U, .endVelocity = V, .time = T}, {{dOf, (u + v) * t / two}, {aOf, (v - u) / t}}},
        {{.displacement = D, .startVelocity = U, .time = T},
         {{vOf, two * d / t - u}, {aOf, two * (d - u * t) / (t * t)}}},
        {{.displacement = D, .endVelocity = V, .time = T},
         {{uOf, two * d / t - v}, {aOf, two * (v * t - d) / (t * t)}}},
        {{.displacement = D, .acceleration = A, .time = T}, {{uOf, d / t - a * t / two}, {vOf, d / t + a * t / two}}},
        {{.startVelocity = U, .endVelocity = V, .acceleration = A},
         {{tOf, (v - u) / a}, {dOf, (v * v - u * u) / (two * a)}}},
        {{.displacement = D, .startVelocity = U, .endVelocity = V},
         {{tOf, two * d / (u + v)}, {aOf, (v * v - u * u) / (two * d)}}},
    };
}

// The textbook's roots: u^2 + 2 a d here, t = (v - u) / a, for v of either sign; and t = (v - u) / a likewise for
// u.
std::vector<Case> quadraticCases(double D, double U, double V, double A) {
    const Bounded d(D), u(U), v(V), a(A), two(2);
    std::vector<Case> list;
    const Bounded ofEnd = u * u + two * a * d, ofStart = v * v - two * a * d;
    for (const double sign : {-1.0, 1.0}) {
        if (ofEnd.value > 4 * ofEnd.error) {
            const Bounded end = Bounded(sign) * root(ofEnd);
            list.push_back({{.displacement = D, .startVelocity = U, .acceleration = A},
                            {{&SolvedMotion::endVelocity, end}, {&SolvedMotion::time, (end - u) / a}}});
        }
        if (ofStart.value > 4 * ofStart.error) {
            const Bounded start = Bounded(sign) * root(ofStart);
            list.push_back({{.displacement = D, .endVelocity = V, .acceleration = A},
                            {{&SolvedMotion::startVelocity, start}, {&SolvedMotion::time, (v - start) / a}}});
        }
    }
    return list;
}

double ulpOf(Long value) {
    const double size = std::fabs(static_cast<double>(value));
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

/// Of the solutions found, the one closest: by how many of the last place it is off beyond what the truth may be.
double worstUlpsOfCase(const Case& c) {
    double best = std::numeric_limits<double>::infinity();
    for (const SolvedMotion& motion : solveMotion(c.known, MotionTimes::AnyReal).motions) {
        double worst = 0;
        for (const auto& [quantity, truth] : c.truth) {
            const Long off = std::fabs(motion.*quantity - truth.value) - truth.error;
            worst = std::max(worst, static_cast<double>(off) / ulpOf(truth.value));
        }
        best = std::min(best, worst);
    }
    return best;
}

double randomNumber(Random& random) {
    return random.uniform(-1, 1) * std::ldexp(1, random.integer(-12, 12));
}

}  // namespace

// A sum of products is within two of the last place; a quotient or a root of it adds half of one each.
TEST_CASE("each of 10,000,000 answers is within four of its last place of the textbook's in long double",
          "[kinematics]") {
    Random random(77);
    double worst = 0;
    std::string at;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double d = randomNumber(random), v = randomNumber(random), a = randomNumber(random);
        const double t = randomNumber(random);
        double u = randomNumber(random);
        // half of them where something cancels: the end velocity, the displacement, the root
        if (i % 8 == 0) u = -a * t * (1 + random.uniform(-1e-6, 1e-6));
        if (i % 8 == 1) u = -a * t / 2 * (1 + random.uniform(-1e-6, 1e-6));
        if (i % 8 == 2) u = d / t * (1 + random.uniform(-1e-6, 1e-6));
        if (i % 8 == 3 && a * d < 0) u = std::sqrt(-2 * a * d) * (1 + random.uniform(0, 1e-6));
        std::vector<Case> list = casesOf(d, u, v, a, t);
        for (Case& c : quadraticCases(d, u, v, a)) list.push_back(std::move(c));
        for (const Case& c : list) {
            const double ulps = worstUlpsOfCase(c);
            if (!(ulps > worst)) continue;
            worst = ulps;
            at = "d " + std::to_string(d) + ", u " + std::to_string(u) + ", v " + std::to_string(v) + ", a " +
                 std::to_string(a) + ", t " + std::to_string(t);
        }
    }
    std::cout << "kinematics, answers against long double: worst " << worst << " ulp, at " << at << '\n';
    CHECK(worst <= 4);
}
