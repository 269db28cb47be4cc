// SPDX-License-Identifier: MIT
#include <compare/report/curve.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace plumb::compare {
namespace {

struct Extremes {
    double first, second;
};

Extremes extremesOf(std::span<const double> values) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double smallest = none;
    double largest = none;
    bool smallestIsFirst = true;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        if (!(value >= smallest)) {
            smallest = value;
            smallestIsFirst = false;
        }
        if (!(value <= largest)) {
            largest = value;
            smallestIsFirst = true;
        }
    }
    return smallestIsFirst ? Extremes{smallest, largest} : Extremes{largest, smallest};
}

}  // namespace

std::size_t curveStride(std::size_t ticks, std::size_t most) {
    if (most < 2) throw std::invalid_argument("curveStride.most: " + std::to_string(most) + " is less than 2");
    if (ticks <= most) return 1;
    const std::size_t pairs = most / 2;
    const std::size_t stride = (ticks + pairs - 1) / pairs;
    return stride + stride % 2;
}

std::vector<double> thinned(std::span<const double> series, std::size_t stride) {
    if (stride <= 1) return {series.begin(), series.end()};
    std::vector<double> points;
    for (std::size_t start = 0; start < series.size(); start += stride) {
        const Extremes extremes = extremesOf(series.subspan(start, std::min(stride, series.size() - start)));
        points.push_back(extremes.first);
        points.push_back(extremes.second);
    }
    return points;
}

}  // namespace plumb::compare
