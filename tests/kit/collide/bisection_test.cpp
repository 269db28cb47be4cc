// SPDX-License-Identifier: MIT
#include <plumb/collide/bisection.h>

#include <cmath>
#include <iostream>

#include <plumb/collide/overlap.h>

#include "cases.h"
#include "catch.h"
#include "kit/collide/fine_stepping.h"
#include "kit/collide/placements.h"

namespace {

using namespace plumb;
using namespace plumb::test;

using Probes = std::vector<double>;

/// A ball of 1 m that falls by 16 m in a frame, onto a floor that it meets after this share of the frame.
std::optional<CollisionTime> ballOnFloor(double contact, int probes) {
    const Shape ball = Circle{0.5}, floor = boxPolygon({50, 50}, {0, -50});
    return bisectCollision(ball, {.start = {0, 0.5 + 16 * contact}, .shift = {0, -16}}, floor, {}, probes);
}

}  // namespace

// The lecture, slide 24: contact in (.375, .4375), probes .5, .25, .375, .4375, .40625; error <= 1/32.
TEST_CASE("the lecture's five probes are 0.5, 0.25, 0.375, 0.4375 and 0.40625", "[collide][sweep][facts]") {
    for (const double contact : {0.376, 0.39, 0.41, 0.437}) {
        const auto time = ballOnFloor(contact, 5);
        REQUIRE(time);
        CHECK(time->probes == Probes{0.5, 0.25, 0.375, 0.4375, 0.40625});
        CHECK(time->error == 1.0 / 32);
        CHECK(time->apart <= contact);
        CHECK(contact <= time->overlapping);
        CHECK(std::fabs(0.40625 - contact) <= 1.0 / 32);
        const auto four = ballOnFloor(contact, 4);
        REQUIRE(four);
        CHECK(four->apart == 0.375);
        CHECK(four->overlapping == 0.4375);
    }
}

TEST_CASE("n probes leave 2^-n of the frame, for n from 0 to 52", "[collide][sweep]") {
    for (int n = 0; n <= 52; ++n) {
        const double begin = 1 / 3.0;
        const auto time = bisectCollision([=](double fraction) { return fraction >= begin; }, n);
        REQUIRE(time);
        CHECK(time->probes.size() == static_cast<std::size_t>(n));
        CHECK(time->error == std::ldexp(1, -n));
        CHECK(time->overlapping - time->apart == time->error);
        CHECK(time->apart < begin);
        CHECK(begin <= time->overlapping);
    }
}

TEST_CASE("halving n times is within 2^-n of the first touch, 100,000 times", "[collide][sweep]") {
    Random random(101);
    int found = 0, sameTouch = 0, faults = 0;
    double worst = 0;
    const int count = cases(100'000);
    for (int i = 0; i < count; ++i) {
        const Shape a = randomShape(random, randomKind(random), 1), b = randomShape(random, randomKind(random), 1);
        const Sweep sweepA{randomVec2(random, 3), randomVec2(random, 3), random.uniform(-3, 3), random.uniform(-1, 1)};
        Sweep sweepB{{0, 0}, randomVec2(random, 3), random.uniform(-3, 3), random.uniform(-1, 1)};
        sweepB.start =
            sweepA.start + sweepA.shift - sweepB.shift + randomVec2(random, 1);  // near each other at the end
        const int n = random.integer(1, 20);
        const auto time = bisectCollision(a, sweepA, b, sweepB, n);
        if (!time || time->error == 0) continue;
        ++found;
        const fine_stepping::Pair pair(a, sweepA, b, sweepB);
        faults += !(pair.gapAt(time->apart) > -1e-12 && pair.gapAt(time->overlapping) < 1e-12);
        // Of several times that they touch it may have found a later one.
        const auto touch = firstTouch(a, sweepA, b, sweepB, 1e-9);
        faults += !touch || touch->time > time->overlapping;
        if (!touch || verdictOn(pair, 0, time->apart) != fine_stepping::Verdict::Apart) continue;
        ++sameTouch;
        const double middle = 0.5 * (time->apart + time->overlapping);
        worst = std::max(worst, std::fabs(middle - touch->time) / time->error);
        // The touch is told so much too early as its tolerance says, where they hardly come on by more.
        faults += touch->time < time->apart - 1e-6;
    }
    std::cout << "[sweep] bisection: " << found << " collisions in " << count << ", " << sameTouch
              << " of them at the first touch: their middle is " << worst << " of 2^-n from it at most; faults "
              << faults << "\n";
    CHECK(faults == 0);
    CHECK(found > count / 4);
    CHECK(sameTouch > found / 2);
}

TEST_CASE("bisection does not see what went right through, nor what touched and parted, it needs an overlap at the end",
          "[collide][sweep]") {
    const Shape bullet = Circle{0.01}, window = boxPolygon({0.05, 1});
    const Sweep through{.start = {-8, 0}, .shift = {1000.0 / 60, 0}};
    CHECK_FALSE(bisectCollision(bullet, through, window, {}));
    CHECK(firstTouch(bullet, through, window, {}));
    CHECK(bisectCollision(bullet, {.start = {-8, 0}, .shift = {8, 0}}, window, {}));
    // From the start on: no later than that.
    const auto since = bisectCollision(bullet, {.start = {0, 0}, .shift = {0.01, 0}}, window, {});
    REQUIRE(since);
    CHECK((since->apart == 0 && since->overlapping == 0 && since->error == 0));
    CHECK(since->probes.empty());
    // Of two beginnings, one: here the later.
    const auto twice = bisectCollision([](double t) { return (t > 0.1 && t < 0.2) || t > 0.7; }, 10);
    REQUIRE(twice);
    CHECK(std::fabs(twice->overlapping - 0.7) <= std::ldexp(1, -10));
    CHECK_THROWS_WITH(bisectCollision([](double) { return true; }, 53),
                      containsText("bisectCollision.probes: 53 is not"));
    CHECK_THROWS_WITH(bisectCollision([](double) { return true; }, -1),
                      containsText("bisectCollision.probes: -1 is not"));
}

// The lecture, slide 25: at 1000 m/s and 1/60 s a bullet moves 16.667 m between two frames.
TEST_CASE("a bullet at 1000 m/s goes 16.667 m a frame: the overlap test misses the window, the swept test never does",
          "[collide][sweep][facts]") {
    constexpr double frame = 1.0 / 60, thickness = 0.1, diameter = 0.02;
    CHECK(std::fabs(1000 * frame - 16.667) < 0.0005);
    const Shape bullet = Circle{diameter / 2}, window = boxPolygon({thickness / 2, 1});
    // Of frames that lie v dt apart, one sees the two overlap for a way of thickness + diameter.
    constexpr double limit = (thickness + diameter) / frame;
    CHECK(std::fabs(limit - 7.2) < 1e-12);
    Random random(103);
    for (const double speed : {1.0, 5.0, 7.19, 7.21, 14.4, 72.0, 340.0, 1000.0}) {
        int seen = 0, swept = 0;
        const int shots = 1000;
        for (int i = 0; i < shots; ++i) {
            const double sweep = speed * frame, before = -10 - random.uniform(0, sweep);
            bool overlapped = false;
            int touched = 0;
            for (double x = before; x < 1; x += sweep) {
                overlapped = overlapped || overlap(bullet, {{x, 0}, {}}, window, {}).has_value();
                touched += firstTouch(bullet, {.start = {x, 0}, .shift = {sweep, 0}}, window, {}).has_value();
            }
            seen += overlapped;
            swept += touched > 0;
        }
        const double expected = std::min(1.0, limit / speed) * shots;
        INFO(speed << " m/s: " << seen << " seen");
        CHECK(swept == shots);
        // Four standard deviations of so many draws.
        CHECK(std::fabs(seen - expected) <= 4 * std::sqrt(expected * (1 - expected / shots)));
        CHECK((seen == shots) == (speed < limit));
    }
}
