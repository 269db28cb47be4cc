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

/// Between a moment and the next. share: of the time between, 0 to 1.
double within(const Course& c, std::size_t i, double share) {
    const double a = c.value[i], b = c.value[i + 1], s = share;
    if (c.slope.empty()) return a + (b - a) * s;
    const double length = c.time[i + 1] - c.time[i], da = c.slope[i] * length, db = c.slope[i + 1] * length;
    return a + s * (da + s * (3 * (b - a) - 2 * da - db + s * (2 * (a - b) + da + db)));
}

/// Where it passes a level between a moment and the next, by halving: it is on different sides at both.
double passes(const Course& c, std::size_t i, double level) {
    const bool isUp = c.value[i + 1] > c.value[i];
    double low = 0, high = 1;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        ((within(c, i, middle) < level) == isUp ? low : high) = middle;
    }
    return c.time[i] + low * (c.time[i + 1] - c.time[i]);
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
        if (side != 0 && now != side) times.push_back(now == 0 ? c.time[i] : passes(c, i - 1, level));
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
        if (is && !was) times.push_back(isFirst ? c.time[i] : passes(c, i - 1, level));
        was = is;
        isFirst = false;
    }
    return times;
}

/// A slope at each moment: where none is known, that from the moment before to the one after.
std::vector<double> slopesOf(const Course& c) {
    if (!c.slope.empty()) return c.slope;
    std::vector<double> slopes(c.value.size(), 0);
    for (std::size_t i = 1; i + 1 < c.value.size(); ++i) {
        const double length = c.time[i + 1] - c.time[i - 1];
        slopes[i] = length > 0 ? (c.value[i + 1] - c.value[i - 1]) / length : 0;
    }
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
        if (before > 0 && slope < 0) times.push_back(c.time[at] + (c.time[i] - c.time[at]) * before / (before - slope));
        before = slope;
        at = i;
    }
    return times;
}

std::vector<double> jumps(const Course& c) {
    std::vector<double> times;
    for (std::size_t i = 1; i < c.time.size(); ++i)
        if (c.time[i] == c.time[i - 1] && (times.empty() || times.back() < c.time[i])) times.push_back(c.time[i]);
    return times;
}

}  // namespace

double valueAt(const Course& course, double time) {
    const auto after = std::ranges::lower_bound(course.time, time);
    if (after == course.time.end()) return course.value.back();
    const auto i = static_cast<std::size_t>(after - course.time.begin());
    if (i == 0 || time == *after) return course.value[i];
    return within(course, i - 1, (time - course.time[i - 1]) / (*after - course.time[i - 1]));
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
        case Kind::Impact: times = jumps(course); break;
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
