// SPDX-License-Identifier: MIT
#include <compare/lab/power_law.h>

#include <cmath>
#include <vector>

namespace plumb::compare {

std::optional<double> exponent(std::span<const Point> points) {
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
