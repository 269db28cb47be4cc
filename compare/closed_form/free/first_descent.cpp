// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/first_descent.h>

#include <cmath>

namespace plumb::compare {
namespace {

constexpr double startRounding = 1e-9;  // a value that is about to fall may already be below 0 by rounding

double valueOf(const std::vector<double>& c, double t) {
    double value = 0;
    for (std::size_t i = c.size(); i-- > 0;) value = value * t + c[i];
    return value;
}

std::vector<double> slopeOf(const std::vector<double>& c) {
    std::vector<double> slope;
    for (std::size_t i = 1; i < c.size(); ++i) slope.push_back(static_cast<double>(i) * c[i]);
    return slope;
}

/// The zero between two points at which the polynomial has different signs.
double between(const std::vector<double>& c, double low, double high) {
    const bool falls = valueOf(c, low) > 0;
    for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
        ((valueOf(c, middle) > 0) == falls ? low : high) = middle;
    return high;
}

/// 0, then the places in (0, end) where the sign changes, in their order, and end.
std::vector<double> changesOf(const std::vector<double>& c, double end) {
    std::vector<double> changes{0};
    if (c.size() > 1) {
        const std::vector<double> extrema = changesOf(slopeOf(c), end);
        for (std::size_t i = 1; i < extrema.size(); ++i)
            if ((valueOf(c, extrema[i - 1]) > 0) != (valueOf(c, extrema[i]) > 0))
                changes.push_back(between(c, extrema[i - 1], extrema[i]));
    }
    changes.push_back(end);
    return changes;
}

std::optional<double> quadraticDescent(double c0, double c1, double c2, double end) {
    const double discriminant = c1 * c1 - 4 * c2 * c0;
    if (discriminant < 0 || (c2 == 0 && c1 >= 0)) return {};
    const double root = std::sqrt(discriminant);
    if (c1 > 0 && c2 >= 0) return {};
    const double t = c1 <= 0 ? 2 * c0 / (-c1 + root) : (-c1 - root) / (2 * c2);
    if (!(t >= -startRounding && t <= end)) return {};
    return t < 0 ? 0 : t;
}

}  // namespace

std::optional<double> firstDescent(const std::vector<double>& coefficients, double end) {
    std::vector<double> c = coefficients;
    while (c.size() > 1 && c.back() == 0) c.pop_back();
    if (c.size() <= 3) {
        c.resize(3, 0);
        return quadraticDescent(c[0], c[1], c[2], end);
    }
    if (std::abs(c[0]) < startRounding * startRounding && c[1] < 0) return 0;
    const std::vector<double> changes = changesOf(c, end);
    for (std::size_t i = 1; i + 1 < changes.size(); ++i) {
        const double before = (changes[i - 1] + changes[i]) / 2;
        if (valueOf(c, before) > 0) return changes[i];
    }
    return {};
}

}  // namespace plumb::compare
