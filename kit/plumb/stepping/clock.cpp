// SPDX-License-Identifier: MIT
#include <plumb/stepping/clock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/detail/exact.h>

namespace plumb {
namespace {

constexpr double earliness = 1e-9;

/// A sum with twice the precision of a double.
struct LongSum {
    double high, low;

    void add(const Exact& number) {
        const Exact sum = exactSum(high, number.value);
        const Exact whole = exactSum(sum.value, low + (sum.lost + number.lost));
        high = whole.value;
        low = whole.lost;
    }
};

void requireSettings(const ClockSettings& settings) {
    requireWithin(settings.interval, 1e-6, 1e6, "ClockSettings.interval");
    requirePositive(settings.longestElapsed, "ClockSettings.longestElapsed");
    requireNotNegative(settings.timeScale, "ClockSettings.timeScale");
    const double most = settings.timeScale * settings.longestElapsed / settings.interval;
    if (!(most <= 1e6))
        refuse("ClockSettings.timeScale", toText(settings.timeScale) + " times longestElapsed is " + toText(most) +
                                              " ticks at once, more than a million");
}

}  // namespace

FixedClock::FixedClock(const ClockSettings& settings) : settings_(settings) {
    requireSettings(settings);
}

void FixedClock::setTimeScale(double timeScale) {
    ClockSettings settings = settings_;
    settings.timeScale = timeScale;
    requireSettings(settings);
    settings_ = settings;
}

Ticks FixedClock::advance(double elapsed) {
    requireNotNegative(elapsed, "FixedClock.advance: elapsed");
    Ticks ticks;
    ticks.due = std::exchange(singleSteps_, 0);
    if (!paused_) {
        const double taken = std::min(elapsed, settings_.longestElapsed);
        ticks.lost = elapsed - taken;
        LongSum since{since_, sinceLow_};
        since.add(exactProduct(taken, settings_.timeScale));
        const double whole = std::floor((since.high + earliness) / settings_.interval);
        since.add(exactProduct(-whole, settings_.interval));
        ticks.due += static_cast<int>(whole);
        since_ = since.high;
        sinceLow_ = since.low;
    }
    tick_ += ticks.due;
    ticks.fraction = std::clamp(since_ / settings_.interval, 0.0, 1 - 0x1p-53);
    return ticks;
}

}  // namespace plumb
