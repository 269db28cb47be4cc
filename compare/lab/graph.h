// SPDX-License-Identifier: MIT
// What is in a graph, and with which power of x does y grow in it?
#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumb::compare {

struct Point {
    double x = 0, y = 0;  ///< NaN for y breaks the line
};

/// In all graphs of a lab, curves with the same name have the same colour. A curve with an engine's name has the
/// engine's colour.
struct Curve {
    std::string name{};
    std::vector<Point> points{};  ///< sorted by rising x
    std::string note{};           ///< shown beside the name: "slope 1.02"
    bool theory = false;          ///< true for an expected curve, which is drawn as a thin dotted line
};

struct Axis {
    std::string label{};       ///< "height"
    std::string unit{};        ///< "m"; empty for a plain number
    bool logarithmic = false;  ///< then values that are not positive are left out
};

struct Graph {
    std::string title{};
    Axis x{}, y{};
    std::vector<Curve> curves{};
};

/// The exponent p in y = c x^p: the slope of the least-squares line through (log x, log y), with distances in log y.
/// Points that are not positive and finite are left out. Empty if fewer than two different x are left.
inline std::optional<double> exponent(std::span<const Point> points) {
    std::vector<Point> logs;
    Point sum;
    for (const Point& point : points) {
        if (!(point.x > 0 && point.y > 0 && std::isfinite(point.x) && std::isfinite(point.y))) continue;
        logs.push_back({std::log(point.x), std::log(point.y)});
        sum.x += logs.back().x;
        sum.y += logs.back().y;
    }
    const auto count = static_cast<double>(logs.size());
    double spread = 0, common = 0;
    for (const Point& point : logs) {
        const double away = point.x - sum.x / count;
        spread += away * away;
        common += away * (point.y - sum.y / count);
    }
    if (!(spread > 0)) return std::nullopt;
    return common / spread;
}

}  // namespace plumb::compare
