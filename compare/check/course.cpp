// SPDX-License-Identifier: MIT
#include <compare/check/course.h>

#include <algorithm>
#include <cmath>

namespace plumb::compare {
namespace {

using Kind = Happening::Kind;

/// What is smaller than this share of the largest is rounding.
constexpr double smallest = 1e-9;

double largestSize(const std::vector<double>& numbers) {
    double most = 0;
    for (const double number : numbers)
        if (std::isfinite(number)) most = std::max(most, std::abs(number));
    return most;
}

/// Within the step after a tick. share: of the step, 0 to 1.
double within(const Course& c, std::size_t tick, double share) {
    const double a = c.value[tick], b = c.value[tick + 1], s = share;
    if (c.slope.empty()) return a + (b - a) * s;
    const double da = c.slope[tick] * c.dt, db = c.slope[tick + 1] * c.dt;
    return a + s * (da + s * (3 * (b - a) - 2 * da - db + s * (2 * (a - b) + da + db)));
}

/// Where it passes a level between a tick and the next, by halving: it is on different sides at both.
double passes(const Course& c, std::size_t tick, double level) {
    const bool isUp = c.value[tick + 1] > c.value[tick];
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        ((within(c, tick, middle) < level) == isUp ? low : high) = middle;
    }
    return (static_cast<double>(tick) + low) * c.dt;
}

/// The times at which it passes a level: it came from one side, and is on the other, or on the level.
std::vector<double> passages(const Course& c, double level) {
    const double near = smallest * std::max(largestSize(c.value), std::abs(level));
    std::vector<double> times;
    int side = 0;
    for (std::size_t i = 0; i < c.value.size(); ++i) {
        const double off = c.value[i] - level;
        if (std::isnan(off)) continue;
        const int now = std::abs(off) <= near ? 0 : off > 0 ? 1 : -1;
        if (side != 0 && now != side)
            times.push_back(now == 0 ? static_cast<double>(i) * c.dt : passes(c, i - 1, level));
        side = now;
    }
    return times;
}

/// The times from which on it is above a level, or below.
std::vector<double> entries(const Course& c, double level, bool above) {
    std::vector<double> times;
    bool was = false, isFirst = true;
    for (std::size_t i = 0; i < c.value.size(); ++i) {
        if (std::isnan(c.value[i])) continue;
        const bool is = above ? c.value[i] > level : c.value[i] < level;
        if (is && !was) times.push_back(isFirst ? static_cast<double>(i) * c.dt : passes(c, i - 1, level));
        was = is;
        isFirst = false;
    }
    return times;
}

/// A slope at each tick: where none is known, that from the tick before to the tick after.
std::vector<double> slopesOf(const Course& c) {
    if (!c.slope.empty()) return c.slope;
    std::vector<double> slopes(c.value.size(), 0);
    for (std::size_t i = 1; i + 1 < c.value.size(); ++i) slopes[i] = (c.value[i + 1] - c.value[i - 1]) / (2 * c.dt);
    return slopes;
}

/// The times at which it stops to grow, or to fall: not its start or end.
std::vector<double> extremes(const Course& c, bool maxima) {
    const std::vector<double> slopes = slopesOf(c);
    const double least = smallest * largestSize(slopes);
    std::vector<double> times;
    double before = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double slope = maxima ? slopes[i] : -slopes[i];
        if (!(std::abs(slope) > least)) continue;
        if (before > 0 && slope < 0)
            times.push_back((static_cast<double>(at) + static_cast<double>(i - at) * before / (before - slope)) * c.dt);
        before = slope;
        at = i;
    }
    return times;
}

}  // namespace

double valueAt(const Course& course, double time) {
    const double ticks = std::clamp(time / course.dt, 0.0, static_cast<double>(course.value.size() - 1));
    const auto tick = static_cast<std::size_t>(ticks);
    const double share = ticks - static_cast<double>(tick);
    return share > 0 ? within(course, tick, share) : course.value[tick];
}

std::optional<double> timeOf(const Course& course, const Happening& event) {
    const double level = event.level.value_or(course.value.front());
    std::vector<double> times;
    switch (event.kind) {
        case Kind::Start: return 0;
        case Kind::Maximum: times = extremes(course, true); break;
        case Kind::Minimum: times = extremes(course, false); break;
        case Kind::Returns: times = passages(course, level); break;
        case Kind::IsAbove: times = entries(course, level, true); break;
        case Kind::IsBelow: times = entries(course, level, false); break;
    }
    const std::size_t which = event.which < 0 ? times.size() : static_cast<std::size_t>(event.which);
    if (which < 1 || which > times.size()) return {};
    return times[which - 1];
}

std::optional<double> periodOf(const Course& course) {
    double least = INFINITY, most = -INFINITY;
    for (const double value : course.value)
        if (!std::isnan(value)) least = std::min(least, value), most = std::max(most, value);
    const std::vector<double> times = passages(course, 0.5 * (least + most));
    if (times.size() < 2) return {};
    const std::size_t halves = times.size() == 2 ? 1 : (times.size() - 1) / 2 * 2;  // whole periods, where there is one
    return 2 * (times[halves] - times.front()) / static_cast<double>(halves);
}

}  // namespace plumb::compare
