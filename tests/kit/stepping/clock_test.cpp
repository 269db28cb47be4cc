// SPDX-License-Identifier: MIT
#include <plumb/stepping/clock.h>

#include <plumb/math/random.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>

#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::test;

constexpr std::array<int, 6> displayRates = {24, 25, 60, 75, 144, 240};

}  // namespace

// The lecture, slides 9 to 11.
TEST_CASE("0.02 s is due 150 times in exactly 3 s at 24, 25, 60, 75, 144 and 240 Hz", "[stepping][rates][facts]") {
    for (const int rate : displayRates) {
        FixedClock clock({.interval = 0.02});
        int due = 0;
        for (int frame = 1; frame <= 3 * rate; ++frame) {
            due += clock.advance(1.0 / rate).due;
            INFO("rate " << rate << ", frame " << frame);
            CHECK(due == frame * 50 / rate);  // an exact tick is not late: at 25 Hz two every frame
        }
        CHECK(due == 150);
        CHECK(clock.tick() == 150);
        CHECK(clock.time() == 3);
    }
}

TEST_CASE("what a plain sum of 0.02 s and of frames loses, the clock does not", "[stepping][rates]") {
    double lag = 0;
    int due = 0;
    FixedClock clock({.interval = 0.02});
    for (int frame = 0; frame < 3 * 60; ++frame) {
        clock.advance(1.0 / 60);
        for (lag += 1.0 / 60; lag >= 0.02; lag -= 0.02) ++due;
    }
    CHECK(due == 149);
    CHECK(clock.tick() == 150);
}

// Whole seconds over ten hours: the nanosecond outlasts what 36,000 s of rounded frames add up to, 4e-12 s.
TEST_CASE("ten hours at any display rate have exactly 50, 60 and 120 ticks a second", "[stepping][rates]") {
    for (const int tickRate : {50, 60, 120}) {
        for (const int rate : displayRates) {
            FixedClock clock({.interval = 1.0 / tickRate});
            int wrong = 0;
            for (int second = 1; second <= cases(36'000); ++second) {
                for (int frame = 0; frame < rate; ++frame) clock.advance(1.0 / rate);
                wrong += clock.tick() != second * tickRate;
            }
            INFO(tickRate << " ticks at " << rate << " Hz");
            CHECK(wrong == 0);
        }
    }
}

// Elapsed times and intervals of whole multiples of 2^-20 s: the truth is a division of integers.
TEST_CASE("in 1,000,000 irregular frames the ticks due are the whole intervals in all the time so far",
          "[stepping][rates]") {
    Random random(41);
    int wrong = 0;
    double worst = 0;
    for (int run = 0; run < 10; ++run) {
        const int interval = random.integer(20'000, 100'000);
        FixedClock clock({.interval = std::ldexp(interval, -20)});
        long long total = 0;
        for (int frame = 0; frame < cases(100'000); ++frame) {
            const int elapsed = random.integer(0, 3) == 0 ? interval : random.integer(0, 200'000);
            total += elapsed;
            const Ticks ticks = clock.advance(std::ldexp(elapsed, -20));
            wrong += clock.tick() != total / interval;
            worst = std::max(worst, std::fabs(ticks.fraction - static_cast<double>(total % interval) / interval));
        }
    }
    std::cout << "stepping, irregular frames: " << wrong << " wrong, fraction within " << worst << '\n';
    CHECK(wrong == 0);
    CHECK(worst == 0);  // T is exact here, and one division rounds alike
}

// Any doubles: the truth is a sum in long double, 11 bits longer; where it cannot tell, within 1e-12 s of a tick's
// moment, either is right.
TEST_CASE("in 1,000,000 frames of any length, scaled by 0.3, every tick comes at its nanosecond", "[stepping][rates]") {
    Random random(43);
    int wrong = 0, near = 0;
    for (int run = 0; run < 10; ++run) {
        const double interval = random.uniform(0.005, 0.05);
        FixedClock clock({.interval = interval, .timeScale = 0.3});
        long double total = 0;
        for (int frame = 0; frame < cases(100'000); ++frame) {
            const double elapsed = random.uniform(0, 0.2);
            total += static_cast<long double>(elapsed) * 0.3;
            clock.advance(elapsed);
            const long double due = (total + 1e-9L) / interval;
            const bool isNear = std::fabs(due - std::round(due)) * interval < 1e-12L;
            near += isNear;
            wrong += !isNear && clock.tick() != static_cast<long long>(std::floor(due));
        }
    }
    CHECK(wrong == 0);
    CHECK(near < 10);
}

TEST_CASE("the fraction says how far between two ticks it is, and is below 1", "[stepping][rates]") {
    FixedClock clock({.interval = 0.5, .longestElapsed = 10});
    CHECK(clock.advance(0.125).fraction == 0.25);
    const Ticks ticks = clock.advance(1);
    CHECK(ticks.due == 2);
    CHECK(ticks.fraction == 0.25);
    const Ticks justBefore = clock.advance(0.375 - 1.1e-9);
    CHECK(justBefore.due == 0);
    CHECK(justBefore.fraction < 1);
    CHECK(justBefore.fraction > 0.99999999);
    const Ticks early = clock.advance(0.2e-9);  // 0.9 ns before its moment: due, and the fraction is 0, not negative
    CHECK(early.due == 1);
    CHECK(early.fraction == 0);
}

TEST_CASE("a stall of 10 s is answered by 15 ticks of 1/60 s, and 9.75 s are reported lost", "[stepping][rates]") {
    FixedClock clock;
    const Ticks stall = clock.advance(10);
    CHECK(stall.due == 15);
    CHECK(stall.lost == 9.75);
    const Ticks next = clock.advance(1.0 / 60);
    CHECK(next.due == 1);
    CHECK(next.lost == 0);
    CHECK(clock.tick() == 16);
    CHECK(clock.advance(1e308).due == 15);
    CHECK(FixedClock({.longestElapsed = 1}).advance(10).due == 60);
}

TEST_CASE("a paused clock makes a tick a single step and goes on where it was", "[stepping][rates]") {
    FixedClock clock({.interval = 0.02});
    clock.advance(0.03);
    CHECK(clock.tick() == 1);
    clock.pause();
    CHECK(clock.paused());
    const Ticks still = clock.advance(0.1);
    CHECK(still.due == 0);
    CHECK(still.fraction == Approx(0.5));
    CHECK(still.lost == 0);
    clock.singleStep();
    CHECK(clock.advance(0.1).due == 1);
    CHECK(clock.advance(0.1).due == 0);
    clock.singleStep();
    clock.singleStep();
    CHECK(clock.advance(0).due == 2);
    CHECK(clock.tick() == 4);
    clock.resume();
    CHECK(clock.advance(0.01).due == 1);  // the 0.03 s and these make two whole intervals, one of them had
    CHECK(clock.tick() == 5);
}

TEST_CASE("slow motion at 1/4 makes a quarter of the ticks, at 0 none, at 3 three times as many", "[stepping][rates]") {
    FixedClock clock({.interval = 0.02, .timeScale = 0.25});
    const auto ticksOfASecond = [&] {
        const std::int64_t before = clock.tick();
        for (int frame = 0; frame < 60; ++frame) clock.advance(1.0 / 60);
        return clock.tick() - before;
    };
    CHECK(ticksOfASecond() + ticksOfASecond() == 25);
    clock.setTimeScale(0);
    CHECK(ticksOfASecond() == 0);
    clock.setTimeScale(3);
    CHECK(clock.timeScale() == 3);
    CHECK(ticksOfASecond() == 150);
}

TEST_CASE("a clock refuses by name what is no time, and is then as it was", "[stepping][rates]") {
    FixedClock clock({.interval = 0.02});
    clock.advance(0.01);
    CHECK_THROWS_WITH(clock.advance(-0.1), "FixedClock.advance: elapsed: -0.1 is negative");
    CHECK_THROWS_WITH(clock.advance(NAN), "FixedClock.advance: elapsed: nan is not finite");
    CHECK_THROWS_WITH(clock.advance(INFINITY), "FixedClock.advance: elapsed: inf is not finite");
    CHECK_THROWS_WITH(clock.setTimeScale(-1), "ClockSettings.timeScale: -1 is negative");
    CHECK_THROWS_WITH(clock.setTimeScale(1e9),
                      "ClockSettings.timeScale: 1000000000 times longestElapsed is 12500000000 "
                      "ticks at once, more than a million");
    CHECK(clock.timeScale() == 1);
    CHECK(clock.advance(0.01).due == 1);
    CHECK_THROWS_WITH(FixedClock({.interval = 0}), "ClockSettings.interval: 0 is not within 1e-06 to 1000000");
    CHECK_THROWS_WITH(FixedClock({.interval = NAN}), "ClockSettings.interval: nan is not finite");
    CHECK_THROWS_WITH(FixedClock({.longestElapsed = 0}), "ClockSettings.longestElapsed: 0 is not positive");
}
