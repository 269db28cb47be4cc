// SPDX-License-Identifier: MIT
#include <plumb/movers/path_mover.h>

#include <cmath>
#include <iostream>

#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"
#include "numbers.h"

namespace {

using namespace plumb;
using namespace plumb::test;

MotionPath line(double length) {
    MotionPath path({0, 0});
    path.lineTo({length, 0});
    return path;
}

MotionPath ring() {
    return splineThrough({{0, 0}, {4, 1}, {6, 5}, {1, 7}, {-3, 2}}, true);
}

MotionPath circlePath() {
    MotionPath path({2, 0});
    path.arcAround({0, 0}, 2 * pi);
    return path;
}

PathTiming randomTiming(Random& random) {
    return {.speed = random.uniform(0.1, 20),
            .easing = static_cast<Easing>(random.integer(0, 2)),
            .acceleration = random.uniform(0.1, 50)};
}

}  // namespace

TEST_CASE("runs take their closed forms' time: 10 m at 2 m/s in 5 s, eased by 1 m/s^2 in 7, by smoothstep in 7.5",
          "[movers]") {
    CHECK(timeOf(10, {.speed = 2}) == 5);
    const PathTiming eased{.speed = 2, .easing = Easing::Acceleration, .acceleration = 1};
    CHECK(timeOf(10, eased) == 7);  // 2 s up over 2 m, 3 s over 6 m, 2 s down
    CHECK(progressAt(10, eased, 1).along == 0.5);
    CHECK(progressAt(10, eased, 1).speed == 1);
    CHECK(progressAt(10, eased, 3.5).along == 5);
    CHECK(progressAt(10, eased, 6).along == 9.5);
    CHECK(timeOf(1, eased) == 2);  // 1 m is too short for 2 m/s: half of it up, half down, to 1 m/s
    CHECK(progressAt(1, eased, 1).speed == 1);
    const PathTiming smooth{.speed = 2, .easing = Easing::SmoothStep};
    CHECK(timeOf(10, smooth) == 7.5);
    CHECK(progressAt(10, smooth, 3.75).speed == 2);
    CHECK(std::fabs(progressAt(10, smooth, 2.5).along - 70.0 / 27) < 1e-15 * 8);  // 10 (1/9) (3 - 2/3)
}

TEST_CASE("10,000 runs: distance is the speed's integral, accelerations stay within what is stated, ends are at rest",
          "[movers]") {
    Random random(1);
    double worstSpeed = 0, worstEase = 0;
    const int runs = cases(10000);
    for (int run = 0; run < runs; ++run) {
        const PathTiming timing = randomTiming(random);
        const double length = random.uniform(0.01, 100), total = timeOf(length, timing);
        const double peak = timing.easing == Easing::Acceleration ? timing.acceleration
                            : timing.easing == Easing::SmoothStep ? 8 * timing.speed * timing.speed / (3 * length)
                                                                  : 0;
        const double t = random.uniform(0, total), step = std::min(1e-4 * total, total - t);
        const Progress a = progressAt(length, timing, t), b = progressAt(length, timing, t + step);
        CAPTURE(run, length, t, static_cast<int>(timing.easing));
        // Trapezium rule: off by step^2 / 4 of the greatest change of acceleration at most, 2 peak; and roundings.
        const double off = std::fabs(b.along - a.along - 0.5 * (a.speed + b.speed) * step);
        REQUIRE(off <= peak * step * step / 2 + length * 0x1p-50);
        // 1e-12 for the rounding of the speeds, over a step of 1e-4 of the time.
        REQUIRE(std::fabs(b.speed - a.speed) <= peak * step * (1 + 1e-9) + timing.speed * 0x1p-48);
        REQUIRE(a.speed <= timing.speed * (1 + 0x1p-50));
        worstSpeed = std::max(worstSpeed, a.speed / timing.speed);
        if (peak > 0 && step > 0) worstEase = std::max(worstEase, std::fabs(b.speed - a.speed) / (peak * step));
        // The same seen from the end.
        const Progress mirrored = progressAt(length, timing, total - t);
        REQUIRE(std::fabs(mirrored.along + a.along - length) <= length * 0x1p-48);
        REQUIRE(progressAt(length, timing, 0).along == 0);
        REQUIRE(progressAt(length, timing, total).along == length);
        REQUIRE(progressAt(length, timing, 2 * total).along == length);
        if (timing.easing != Easing::None) REQUIRE(progressAt(length, timing, 0).speed == 0);
        if (timing.easing != Easing::None) REQUIRE(progressAt(length, timing, total).speed == 0);
    }
    std::cout << runs << " runs: at most " << worstSpeed << " of the speed, " << worstEase
              << " of the stated acceleration\n";
}

TEST_CASE("a million laps later it is where it was on the first, on a spline as on a circle", "[movers]") {
    for (const MotionPath& path : {ring(), circlePath()}) {
        const PathMover mover({.path = path, .timing = {.speed = 3}, .repeat = PathRepeat::Loop});
        const double lap = mover.period();
        CHECK(std::fabs(lap - path.length() / 3) < 1e-14 * lap);
        double worst = 0;
        for (int i = 0; i < 100; ++i) {
            const double part = (i + 0.5) / 100 * lap, time = 1e6 * lap + part;
            const PathState first = mover.at(part), late = mover.at(time);
            CHECK(late.lap == 1000000);
            worst = std::max(worst, (late.position - first.position).norm());
            // On the path exactly: at its own way along it.
            CHECK(late.position == path.at(late.along).position);
        }
        // The phase: 1e6 laps, rounded by 2^-53, of 2^23 s or less here; and the lap, a million times 2^-53 of itself.
        CHECK(worst < 3 * (0x1p23 * 0x1p-52 + 1e6 * lap * 0x1p-53) + 1e-10);
        std::cout << "a million laps of " << lap << " s: at most " << worst << " m off the first\n";
    }
}

TEST_CASE("at any tick of 1/60 s a loop keeps its speed along a spline: 5 m/s to the tolerance", "[movers]") {
    const MotionPath path = ring();
    const PathMover mover({.path = path, .timing = {.speed = 5}, .repeat = PathRepeat::Loop});
    double worst = 0, sum = 0;
    for (std::int64_t tick = 0; tick < 6000; ++tick) {
        const PathState a = mover.atTick(tick, 1.0 / 60);
        CHECK(std::fabs(a.velocity.norm() - 5) < 1e-14);
        CHECK(std::fabs(cross(a.velocity, a.tangent)) < 5 * 0x1p-51);
        // The velocity is the position's derivative: central differences, off by h^2 / 6 of the third derivative.
        const double h = 1e-5, t = static_cast<double>(tick) / 60 + h;
        const Vec2 slope = (mover.at(t + h).position - mover.at(t - h).position) / (2 * h);
        worst = std::max(worst, (slope - mover.at(t).velocity).norm());
        sum += slope.norm();
    }
    // Bends of half a metre at the sharpest: v^3 / r^2 h^2 / 6 = 8e-9; a point of the spline in the span, where bends
    // jump by 2 1/m at most: v^2 2 h / 4 = 1.3e-4; places off by 1e-11 of 10 m over h: 2e-5.
    CHECK(worst < 1.6e-4);
    CHECK(std::fabs(sum / 6000 - 5) < 1e-5);
    std::cout << "velocity against differences along a spline: at most " << worst << " of 5 m/s\n";
}

TEST_CASE("back and forth is the same there as back, backward: 1,000 movers with stops and easing", "[movers]") {
    Random random(3);
    double worst = 0;
    for (int run = 0; run < cases(1000); ++run) {
        const MotionPath path = splineThrough({{0, 0}, {random.uniform(1, 5), 2}, {random.uniform(-5, 0), 9}});
        const double length = path.length();
        PathMoverDef def{.path = path, .timing = randomTiming(random), .repeat = PathRepeat::BackAndForth};
        for (const double part : {0.0, 0.2, 0.7, 1.0})
            if (random.integer(0, 1) == 0) def.stops.push_back({part * length, random.uniform(0, 2)});
        const PathMover mover(def);
        // The middle of the rest at the far end, and of that at the start.
        double pauses = 0, atStart = 0;
        for (const PathStop& stop : def.stops) {
            pauses += stop.along > 0 && stop.along < length ? 2 * stop.pause : stop.pause;
            if (stop.along == 0) atStart = stop.pause;
        }
        REQUIRE(mover.period() > pauses);
        const double end = (mover.period() + atStart) / 2;
        const double t = random.uniform(0, (mover.period() - atStart) / 2);
        const PathState there = mover.at(end - t), back = mover.at(end + t);
        CAPTURE(run, t);
        worst = std::max(worst, (there.position - back.position).norm());
        // Times of up to a thousand seconds, rounded by 2^-43, at 20 m/s.
        REQUIRE((there.position - back.position).norm() < 20 * 16 * 0x1p-43 + 1e-10);
        REQUIRE(there.lap == 0);
        REQUIRE(mover.at(end + t + 5 * mover.period()).lap == 5);
        REQUIRE((there.velocity + back.velocity).norm() < 1e-6);
    }
    std::cout << "back and forth: places there and back differ by at most " << worst << " m\n";
}

TEST_CASE("stops on a line: 1 m/s, 2 s at 3 m, 1 s at 10 m, and it is finished after 13 s", "[movers]") {
    const PathMover mover({.path = line(10), .stops = {{3, 2}, {10, 1}}});
    CHECK(mover.period() == 13);
    const auto x = [&](double time) { return mover.at(time).position.x(); };
    CHECK(x(2.5) == 2.5);
    CHECK(x(3) == 3);
    CHECK(x(4.9) == 3);
    CHECK(mover.at(4).velocity == Vec2(0, 0));
    CHECK(mover.at(4).tangent == Vec2(1, 0));
    CHECK(x(5.5) == 3.5);
    CHECK(mover.at(5.5).velocity == Vec2(1, 0));
    CHECK(x(12.5) == 10);
    CHECK_FALSE(mover.at(12.5).finished);
    CHECK(mover.at(13).finished);
    CHECK(x(1e9) == 10);
    CHECK(mover.at(1e9).velocity == Vec2(0, 0));

    const PathMover shuttle({.path = line(10), .repeat = PathRepeat::BackAndForth, .stops = {{0, 1}, {3, 2}, {10, 4}}});
    CHECK(shuttle.period() == 29);  // 20 m, 1 s, twice 2 s and 4 s
    CHECK(shuttle.at(0.5).position.x() == 0);
    CHECK(shuttle.at(1 + 3 + 2 + 7 + 4 + 1).position.x() == 9);
    CHECK(shuttle.at(18).velocity == Vec2(-1, 0));
    CHECK(shuttle.at(18).tangent == Vec2(1, 0));
    CHECK(shuttle.at(29 + 1.5).position.x() == 0.5);
    CHECK(shuttle.at(29 + 1.5).lap == 1);
}

TEST_CASE("a kinematic body told each tick is on the path after each step, and has turned round with it three times",
          "[movers]") {
    const PathMover mover({.path = circlePath(), .timing = {.speed = 4}, .repeat = PathRepeat::Loop});
    World world;
    const BodyId platform =
        world.add({.type = BodyType::Kinematic, .position = {2, 0}, .angle = pi / 2, .shapes = {box({0.5, 0.1})}});
    const auto laps = static_cast<std::int64_t>(3 * mover.period() / dt);
    double worst = 0;
    for (std::int64_t tick = 0; tick < laps; ++tick) {
        const PathPose pose = mover.poseAfter(tick, dt, world.body(platform).angle());
        world.body(platform).moveTo(pose.position, pose.angle, dt);
        world.step(dt);
        const double angle = 2 * static_cast<double>(tick + 1) * dt;
        const Vec2 there(2 * std::cos(angle), 2 * std::sin(angle));
        worst = std::max(worst, (world.body(platform).position() - there).norm());
        CHECK(std::fabs(world.body(platform).angle() - angle - pi / 2) < 1e-12);
    }
    CHECK(worst < 1e-12);
    CHECK(world.body(platform).angle() > 3 * 2 * pi + pi / 2 - 0.1);
    std::cout << "kinematic body on a circle: at most " << worst << " m off after a step\n";
}

TEST_CASE("unsound movers and times are refused by name", "[movers]") {
    const double nan = std::nan("");
    CHECK_THROWS_WITH(PathMover({.path = MotionPath({0, 0})}), "PathMoverDef.path: length: 0 is not positive");
    CHECK_THROWS_WITH(PathMover({.path = line(1), .repeat = PathRepeat::Loop}),
                      "PathMoverDef.repeat: Loop needs a closed path; this one ends at (1, 0)");
    CHECK_THROWS_WITH(PathMover({.path = line(1), .timing = {.speed = 0}}), "PathTiming.speed: 0 is not positive");
    for (const double bad : {nan, infinity, -1.0, 0.0}) {
        CHECK_THROWS_AS(PathMover({.path = line(1), .timing = {.speed = bad}}), std::invalid_argument);
        CHECK_THROWS_AS(PathMover({.path = line(1), .timing = {.easing = Easing::Acceleration, .acceleration = bad}}),
                        std::invalid_argument);
        if (bad != 0) CHECK_THROWS_AS(PathMover({.path = line(1), .stops = {{0.5, bad}}}), std::invalid_argument);
        CHECK_THROWS_AS(timeOf(bad, {}), std::invalid_argument);
    }
    CHECK_THROWS_WITH(PathMover({.path = line(1), .stops = {{2, 0}}}),
                      "PathMoverDef.stops[0].along: 2 is not within 0 to 1");
    CHECK_THROWS_WITH(PathMover({.path = line(1), .stops = {{0.5, 0}, {0.5, 1}}}),
                      "PathMoverDef.stops[1].along: 0.5 is not beyond the one before");
    CHECK_THROWS_AS(PathMover({.path = line(1), .timing = {.speed = 1e-320}}), std::invalid_argument);
    const PathMover mover({.path = line(1)});
    for (const double bad : {nan, infinity, -0.5}) CHECK_THROWS_AS(mover.at(bad), std::invalid_argument);
    CHECK_THROWS_AS(mover.poseAfter(0, 0), std::invalid_argument);
    CHECK_THROWS_AS(mover.poseAfter(0, 1, nan), std::invalid_argument);
    CHECK_THROWS_AS(mover.atTick(-1, 1), std::invalid_argument);
    CHECK_THROWS_AS(progressAt(1, {}, nan), std::invalid_argument);
}
