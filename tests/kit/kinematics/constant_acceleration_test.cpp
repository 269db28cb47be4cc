// SPDX-License-Identifier: MIT
#include <plumb/kinematics/constant_acceleration.h>

#include <plumb/math/random.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// d, u, v, a, t
using Five = std::array<double, 5>;

Five fiveOf(const SolvedMotion& m) {
    return {m.displacement, m.startVelocity, m.endVelocity, m.acceleration, m.time};
}

/// The five less the two that the bits of a mask leave out.
KnownMotion knownOf(const Five& five, int mask) {
    const auto part = [&](std::size_t i) { return mask >> i & 1 ? std::optional(five[i]) : std::nullopt; };
    return {part(0), part(1), part(2), part(3), part(4)};
}

std::string nameOf(int mask) {
    std::string name;
    for (std::size_t i = 0; i < 5; ++i)
        if (mask >> i & 1) name += "duvat"[i];
    return name;
}

bool isThree(int mask) {
    int count = 0;
    for (int i = 0; i < 5; ++i) count += mask >> i & 1;
    return count == 3;
}

/// A motion whose five numbers are doubles without rounding: whole multiples of powers of two, below 2^53 of them.
/// Often one is 0, and often velocity or displacement at the end is what little is left of much.
Five exactMotion(Random& random) {
    const auto some = [&](int most, double unit) {
        return random.integer(0, 9) == 0 ? 0 : unit * random.integer(-most, most);
    };
    const double t = some(1 << 10, 0x1p-5), a = some(1 << 20, 0x1p-9);
    double u = some(1 << 20, 0x1p-10);
    if (random.integer(0, 3) == 0) u = -a * t + some(8, 0x1p-15);
    if (random.integer(0, 3) == 0) u = -a * t / 2 + some(8, 0x1p-15);
    const double length = std::ldexp(1, random.integer(-40, 40)), time = std::ldexp(1, random.integer(-40, 40));
    return {(u * t + a * t * t / 2) * length, u * length / time, (u + a * t) * length / time, a * length / time / time,
            t * time};
}

double ulpsBetween(double found, double truth) {
    if (found == truth) return 0;
    const double size = std::fabs(truth);
    const double next = std::nextafter(size, std::numeric_limits<double>::infinity());
    return truth == 0 ? std::numeric_limits<double>::infinity() : std::fabs(found - truth) / (next - size);
}

double worstUlps(const SolvedMotion& found, const Five& truth) {
    double worst = 0;
    for (std::size_t i = 0; i < 5; ++i) worst = std::max(worst, ulpsBetween(fiveOf(found)[i], truth[i]));
    return worst;
}

/// Whether other motions share what the mask shows of this one: then the equations only say 0 = 0.
bool leavesOpen(const Five& m, const std::string& known) {
    const auto [d, u, v, a, t] = m;
    if (known == "uva") return a == 0;
    if (known == "duv") return d == 0 && (u == v || u == -v);
    if (known == "dua") return a == 0 && u == 0;
    if (known == "dva") return a == 0 && v == 0;
    return t == 0 && known != "uat" && known != "vat";
}

std::size_t howMany(const Five& m, const std::string& known) {
    const auto [d, u, v, a, t] = m;
    if (leavesOpen(m, known)) return 0;
    if (known == "dua") return a != 0 && v != 0 ? 2 : 1;
    if (known == "dva") return a != 0 && u != 0 ? 2 : 1;
    return 1;
}

/// How far from right the two equations are that hold between all five, and that were not used as they stand.
double replayError(const SolvedMotion& m) {
    using Exact = long double;
    const Exact d = m.displacement, u = m.startVelocity, v = m.endVelocity, a = m.acceleration, t = m.time;
    const Exact way = std::fabs(d - (u + v) / 2 * t),
                ofWay = std::fabs(d) + (std::fabs(u) + std::fabs(v)) * std::fabs(t);
    const Exact energy = std::fabs(v * v - u * u - 2 * a * d), ofEnergy = v * v + u * u + 2 * std::fabs(a * d);
    return static_cast<double>(std::max(ofWay > 0 ? way / ofWay : 0, ofEnergy > 0 ? energy / ofEnergy : 0));
}

}  // namespace

// All five numbers are doubles, whatever cancels between them: so each is to come out as it is.
TEST_CASE("1,000,000 motions are found again from any three of their five numbers", "[kinematics]") {
    for (int mask = 0; mask < 32; ++mask) {
        if (!isThree(mask)) continue;
        const std::string known = nameOf(mask);
        Random random(500 + static_cast<std::uint64_t>(mask));
        int faults = 0;
        double worst = 0;
        for (int i = 0; i < cases(1'000'000); ++i) {
            const Five truth = exactMotion(random);
            const MotionSolutions found = solveMotion(knownOf(truth, mask), MotionTimes::AnyReal);
            double least = found.motions.empty() ? 0 : std::numeric_limits<double>::infinity();
            for (const SolvedMotion& motion : found.motions) least = std::min(least, worstUlps(motion, truth));
            worst = std::max(worst, least);
            faults += found.motions.size() != howMany(truth, known);
            faults += found.infinitelyMany != leavesOpen(truth, known);
        }
        std::cout << "kinematics, " << known << " known: worst " << worst << " ulp, " << faults << " faults\n";
        INFO("known " << known);
        CHECK(faults == 0);
        CHECK(worst == 0);
    }
}

// Rounding of d, u, v, a, t by four of the last place each: 2^-53 times the 4 to 12 that the equations add up.
TEST_CASE("what 1,000,000 random threes give obeys the equations that were not used", "[kinematics]") {
    constexpr double eps = 0x1p-53;
    for (int mask = 0; mask < 32; ++mask) {
        if (!isThree(mask)) continue;
        Random random(900 + static_cast<std::uint64_t>(mask));
        double worst = 0, worstVieta = 0;
        int none = 0, two = 0, unsorted = 0;
        for (int i = 0; i < cases(1'000'000); ++i) {
            Five five{};
            for (double& number : five) number = random.uniform(-1, 1) * std::ldexp(1, random.integer(-20, 20));
            const MotionSolutions found = solveMotion(knownOf(five, mask), MotionTimes::AnyReal);
            for (const SolvedMotion& motion : found.motions) worst = std::max(worst, replayError(motion));
            none += found.motions.empty();
            if (found.motions.size() != 2) continue;
            ++two;
            const SolvedMotion &one = found.motions[0], &other = found.motions[1];
            unsorted += !(one.time <= other.time);
            // Vieta, from the start or from the end: the middle of both is at -u / a, or t - v / a before
            const double fixed =
                mask >> 1 & 1 ? -2 * one.startVelocity / one.acceleration : 2 * one.endVelocity / one.acceleration;
            worstVieta = std::max(
                worstVieta, std::fabs(one.time + other.time - fixed) / (std::fabs(one.time) + std::fabs(other.time)));
        }
        const std::string known = nameOf(mask);
        std::cout << "kinematics, random " << known << ": replay within " << worst << ", " << two << " twice, " << none
                  << " never\n";
        INFO("known " << known);
        CHECK(worst < 12 * eps);
        CHECK(worstVieta < 8 * eps);
        CHECK(unsorted == 0);
        CHECK((none > 0) == (known == "dua" || known == "dva"));
    }
}

TEST_CASE("whether a throw reaches a height is decided to the last bit: 10 m/s against 12.8 m/s^2, at 3.90625 m",
          "[kinematics]") {
    const double height = 3.90625, above = std::nextafter(height, 9), below = std::nextafter(height, 0);
    const auto times = [](double d) {
        return solveMotion({.displacement = d, .startVelocity = 10, .acceleration = -12.8}).motions.size();
    };
    // As a double 12.8 is a little more, and the apex a little below 3.90625, which doubles alone do not see.
    CHECK(10 * 10 + 2 * -12.8 * height == 0);
    CHECK(times(height) == 0);
    CHECK(times(above) == 0);
    CHECK(times(below) == 2);
    const MotionSolutions apex = solveMotion({.displacement = 4, .startVelocity = 8, .acceleration = -8});
    REQUIRE(apex.motions.size() == 1);
    CHECK(apex.motions[0].time == 1);
    CHECK(apex.motions[0].endVelocity == 0);
}

// The lecture, slide 7: thrown up at 10 m/s, a ball rises 5 m where g is 10; section 3: apex = v_y^2 / 2g.
TEST_CASE("a ball thrown up at 10 m/s rises 5 m at g = 10, at 45 degrees and 20 m/s 10.193679918 m at 9.81",
          "[kinematics][facts]") {
    const MotionSolutions toss = solveMotion({.startVelocity = 10, .endVelocity = 0, .acceleration = -10});
    REQUIRE(toss.motions.size() == 1);
    CHECK(toss.motions[0].displacement == 5);
    CHECK(toss.motions[0].time == 1);
    const double up = 20 * std::sqrt(0.5);
    const MotionSolutions lob = solveMotion({.startVelocity = up, .endVelocity = 0, .acceleration = -9.81});
    CHECK(std::fabs(lob.motions.at(0).displacement - 10.193679918) < 5e-10);
    const MotionSolutions back = solveMotion({.displacement = 0, .startVelocity = up, .acceleration = -9.81});
    REQUIRE(back.motions.size() == 2);
    CHECK(back.motions[0].time == 0);
    CHECK(std::fabs(back.motions[1].time - 2.8832080782) < 5e-11);  // the same section, "v=20 exact limit"
}

// Worked numbers of the integrators: 1 s of free fall, the exact step: -4.905.
TEST_CASE("ten steps of 0.1 s of free fall end at -4.905 m", "[kinematics][facts]") {
    PointMotion ball;
    for (int i = 0; i < 10; ++i) ball = moveAccelerated(ball, {0, -9.81}, 0.1);
    CHECK(std::fabs(ball.position.y() + 4.905) < 1e-14);
    CHECK(std::fabs(ball.velocity.y() + 9.81) < 1e-14);
}

TEST_CASE("a time before the start is a solution only where it is asked for", "[kinematics]") {
    const KnownMotion thrown{.displacement = -15, .startVelocity = 10, .acceleration = -10};
    const MotionSolutions later = solveMotion(thrown);
    REQUIRE(later.motions.size() == 1);
    CHECK(later.motions[0].time == 3);
    CHECK(later.motions[0].endVelocity == -20);
    const MotionSolutions ever = solveMotion(thrown, MotionTimes::AnyReal);
    REQUIRE(ever.motions.size() == 2);
    CHECK(ever.motions[0].time == -1);
    CHECK(ever.motions[0].endVelocity == 20);
    CHECK(solveMotion({.startVelocity = 1, .acceleration = 2, .time = -3}).motions.empty());
}

TEST_CASE("what contradicts itself has no solution, and what says nothing has infinitely many", "[kinematics]") {
    const MotionSolutions never = solveMotion({.startVelocity = 1, .endVelocity = 2, .acceleration = 0});
    CHECK(never.motions.empty());
    CHECK_FALSE(never.infinitelyMany);
    const MotionSolutions any = solveMotion({.displacement = 0, .startVelocity = 0, .acceleration = 0});
    CHECK(any.motions.empty());
    CHECK(any.infinitelyMany);
    CHECK_FALSE(solveMotion({.displacement = 1, .startVelocity = 2, .endVelocity = -2}).infinitelyMany);
    CHECK(solveMotion({.displacement = 0, .startVelocity = 2, .endVelocity = -2}).infinitelyMany);
    CHECK(solveMotion({.displacement = 0, .startVelocity = 2, .endVelocity = 3}).motions.empty());
    CHECK(solveMotion({.displacement = 1, .acceleration = 2, .time = 0}).motions.empty());
}

TEST_CASE("two, four or five knowns, and what is no number, are refused by name", "[kinematics]") {
    CHECK_THROWS_WITH(solveMotion(KnownMotion{}), "KnownMotion: nothing is given; three of the five are wanted");
    CHECK_THROWS_WITH(solveMotion({.displacement = 1, .time = 2}),
                      "KnownMotion: displacement, time is given; three of the five are wanted");
    CHECK_THROWS_WITH(solveMotion({.displacement = 1, .startVelocity = 1, .endVelocity = 1, .time = 1}),
                      containsText("three of the five"));
    CHECK_THROWS_WITH(solveMotion({1, 1, 1, 0, 1}), containsText("three of the five"));
    CHECK_THROWS_WITH(solveMotion({.displacement = 1, .startVelocity = NAN, .time = 2}),
                      "KnownMotion.startVelocity: nan is not finite");
    CHECK_THROWS_WITH(solveMotion({.startVelocity = 1, .acceleration = INFINITY, .time = 2}),
                      "KnownMotion.acceleration: inf is not finite");
    CHECK_THROWS_WITH(solveMotion(KnownPlaneMotion{.displacement = Vec2(1, NAN)}),
                      "KnownPlaneMotion.displacement: (1, nan) is not finite");
    CHECK_THROWS_WITH(solveMotion(KnownPlaneMotion{.displacement = Vec2(1, 2), .time = 1}),
                      "KnownPlaneMotion: displacement is given; two of the four vectors are wanted");
    CHECK_THROWS_WITH(moveAccelerated({}, {0, 1}, NAN), "time: nan is not finite");
}

TEST_CASE("the largest and smallest numbers give finite solutions, or none", "[kinematics]") {
    const std::array<double, 7> extremes = {0, 5e-324, 1e-300, 1, 1e300, 1.7e308, -1.7e308};
    int bad = 0, found = 0;
    for (int mask = 0; mask < 32; ++mask) {
        if (!isThree(mask)) continue;
        for (int i = 0; i < 7 * 7 * 7; ++i) {
            Five five{};
            int digit = i;
            for (std::size_t k = 0; k < 5; ++k) {
                if (!(mask >> k & 1)) continue;
                five[k] = extremes[static_cast<std::size_t>(digit % 7)];
                digit /= 7;
            }
            for (const SolvedMotion& motion : solveMotion(knownOf(five, mask), MotionTimes::AnyReal).motions) {
                ++found;
                for (const double number : fiveOf(motion)) bad += !std::isfinite(number);
            }
        }
    }
    CHECK(bad == 0);
    CHECK(found > 1000);
}

TEST_CASE("a motion in the plane is that of its axes", "[kinematics]") {
    const PlaneMotionSolution shot =
        solveMotion(KnownPlaneMotion{.displacement = Vec2(30, 5), .acceleration = Vec2(0, -9.81), .time = 2});
    REQUIRE(shot.motion);
    CHECK((shot.motion->startVelocity - Vec2(15, 12.31)).norm() <
          1e-14);  // Worked numbers of the firing solution, "t=2 to d"
    CHECK((shot.motion->endVelocity - Vec2(15, 12.31 - 2 * 9.81)).norm() < 1e-14);
    const PlaneMotionSolution open =
        solveMotion(KnownPlaneMotion{.startVelocity = Vec2(1, 2), .endVelocity = Vec2(1, 2)});
    CHECK_FALSE(open.motion);
    CHECK(open.infinitelyMany);
    const PlaneMotionSolution none =
        solveMotion(KnownPlaneMotion{.startVelocity = Vec2(1, 2), .endVelocity = Vec2(1, 3)});
    CHECK_FALSE(none.motion);
    CHECK_FALSE(none.infinitelyMany);
}

// 60 steps, each rounding a place of some 100 m and a speed of some 30 m/s twice.
TEST_CASE("a motion in steps is the motion at once", "[kinematics]") {
    const PointMotion start{{3, 4}, {20, 30}};
    PointMotion point = start;
    for (int i = 0; i < 60; ++i) point = moveAccelerated(point, {1, -9.81}, 0.05);
    const PointMotion atOnce = moveAccelerated(start, {1, -9.81}, 3);
    CHECK((point.position - atOnce.position).norm() < 60 * 4 * 1e-14);
    CHECK((point.velocity - atOnce.velocity).norm() < 60 * 4 * 4e-15);
}
