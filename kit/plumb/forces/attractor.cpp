// SPDX-License-Identifier: MIT
#include <plumb/forces/attractor.h>

#include <cmath>
#include <numbers>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const Attractor& attractor) {
    requireFinite(attractor.strength, "Attractor", ".strength");
    requireWithin(attractor.power, 1, 8, "Attractor", ".power");
    requireNotNegative(attractor.softening, "Attractor", ".softening");
    if (!(attractor.range > 0)) requirePositive(attractor.range, "Attractor", ".range");
}

double softened(const Attractor& attractor, double squaredDistance) {
    return std::sqrt(squaredDistance + attractor.softening * attractor.softening);
}

/// ln x, x > 0: ln (m 2^k) with m near 1, by the series of the hyperbolic arc tangent.
double naturalLogarithm(double x) {
    if (x == 0) return -std::numeric_limits<double>::infinity();
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0.70710678118654752) m *= 2, --exponent;
    const double z = (m - 1) / (m + 1);
    double sum = 0;
    for (int i = 21; i >= 3; i -= 2) sum = (sum + 1.0 / i) * z * z;
    return 2 * (z + z * sum) + exponent * std::numbers::ln2;
}

double raised(double base, int power) {
    double product = 1;
    for (int i = 0; i < power; ++i) product *= base;
    return product;
}

/// Without a range; q softened distance.
double energyAt(const Attractor& attractor, double q) {
    if (attractor.power == 1) return attractor.strength * naturalLogarithm(q);
    const int n = attractor.power - 1;
    return -attractor.strength / (n * raised(q, n));
}

}  // namespace

Vec2 attraction(const Attractor& attractor, const Vec2& position) {
    requireSound(attractor);
    const Vec2 d = position - attractor.center;
    const double squared = d.squaredNorm();
    if (squared > attractor.range * attractor.range) return {0, 0};
    const double divisor = raised(softened(attractor, squared), attractor.power + 1);
    if (divisor == 0) return {0, 0};  // at the centre, or too near for numbers
    return -(attractor.strength / divisor) * d;
}

double potentialEnergy(const Attractor& attractor, const Vec2& position) {
    requireSound(attractor);
    if (attractor.strength == 0) return 0;
    const double squared = (position - attractor.center).squaredNorm();
    const double limit = attractor.range * attractor.range;
    if (squared > limit) return 0;
    const double energy = energyAt(attractor, softened(attractor, squared));
    return std::isfinite(attractor.range) ? energy - energyAt(attractor, softened(attractor, limit)) : energy;
}

}  // namespace plumb
