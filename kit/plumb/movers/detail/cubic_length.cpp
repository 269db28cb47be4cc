// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/cubic_length.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

/// Nodes and weights of Gauss-Legendre quadrature on -1 to 1, of degree 9. Source: Abramowitz and Stegun, table 25.4.
constexpr std::array<double, 3> gaussNodes{0, 0.538469310105683091, 0.906179845938663993};
constexpr std::array<double, 3> gaussWeights{0.568888888888888889, 0.478628670499366468, 0.236926885056189088};

constexpr double agreement = 1e-12;
constexpr int deepest = 40;

}  // namespace

Vec2 Cubic::at(double u) const {
    const double v = 1 - u;
    return v * v * v * points[0] + 3 * v * v * u * points[1] + 3 * v * u * u * points[2] + u * u * u * points[3];
}

Vec2 Cubic::derivative(double u) const {
    const double v = 1 - u;
    return 3 *
           (v * v * (points[1] - points[0]) + 2 * v * u * (points[2] - points[1]) + u * u * (points[3] - points[2]));
}

Vec2 Cubic::tangent(double u) const {
    const double least = 1e-9 * size();
    Vec2 direction = derivative(u);
    // Where the first derivative vanishes, the direction is that of the second derivative, or of the chord.
    if (direction.norm() <= least) {
        const double v = 1 - u;
        const Vec2 second =
            6 * (v * (points[2] - 2 * points[1] + points[0]) + u * (points[3] - 2 * points[2] + points[1]));
        direction = u < 1 ? second : Vec2(-second);
    }
    if (direction.norm() <= least) direction = points[3] - points[0];
    const double length = direction.norm();
    return length > 0 ? Vec2(direction / length) : Vec2(1, 0);
}

double Cubic::size() const {
    return (points[1] - points[0]).norm() + (points[2] - points[1]).norm() + (points[3] - points[2]).norm();
}

CubicLength::CubicLength(const Cubic& cubic) : cubic_(cubic), nodes_{{0, 0}} {
    divide(0, 1, measure(0, 1), 0);
}

double CubicLength::measure(double from, double to) const {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = gaussWeights[0] * cubic_.derivative(middle).norm();
    for (std::size_t i = 1; i < gaussNodes.size(); ++i)
        sum += gaussWeights[i] * (cubic_.derivative(middle - half * gaussNodes[i]).norm() +
                                  cubic_.derivative(middle + half * gaussNodes[i]).norm());
    return half * sum;
}

void CubicLength::divide(double from, double to, double whole, int depth) {
    const double middle = 0.5 * (from + to);
    const double first = measure(from, middle), second = measure(middle, to);
    // Not <=, which would be false for the NaN of an overflow, at every depth.
    const bool differs = std::fabs(first + second - whole) > agreement * cubic_.size() * (to - from);
    if (!differs || depth == deepest) {
        nodes_.push_back({middle, nodes_.back().along + first});
        nodes_.push_back({to, nodes_.back().along + second});
        return;
    }
    divide(from, middle, first, depth + 1);
    divide(middle, to, second, depth + 1);
}

double CubicLength::parameterAt(double along) const {
    along = std::clamp(along, 0.0, length());
    const auto after = std::lower_bound(nodes_.begin() + 1, nodes_.end() - 1, along,
                                        [](const Node& node, double distance) { return node.along < distance; });
    const Node& start = *(after - 1);
    double low = start.u, high = after->u;
    const double span = after->along - start.along;
    double u = span > 0 ? low + (high - low) * ((along - start.along) / span) : low;
    // Newton's method, kept within the interval; 60 halvings exhaust the precision of a double.
    for (int round = 0; round < 60; ++round) {
        const double miss = start.along + measure(start.u, u) - along;
        if (std::fabs(miss) <= 0x1p-50 * cubic_.size()) break;
        (miss > 0 ? high : low) = u;
        const double speed = cubic_.derivative(u).norm();
        const double next = speed > 0 ? u - miss / speed : low;
        u = next > low && next < high ? next : 0.5 * (low + high);
    }
    return u;
}

}  // namespace plumb
