// SPDX-License-Identifier: MIT
#include <plumb/forces/attractor.h>

#include <cmath>

#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/logarithm.h>

namespace plumb {
namespace {

double softened(const Attractor& attractor, double squaredDistance) {
    return std::sqrt(squaredDistance + attractor.softening * attractor.softening);
}

double raised(double base, int power) {
    double product = 1;
    for (int i = 0; i < power; ++i) product *= base;
    return product;
}

/// Without a range; q is the softened distance.
double energyAt(const Attractor& attractor, double q) {
    if (attractor.power == 1) return attractor.strength * logarithm(q);
    const int n = attractor.power - 1;
    return -attractor.strength / (n * raised(q, n));
}

}  // namespace

Vec2 attraction(const Attractor& attractor, const Vec2& position) {
    requireNumbers(attractor);
    const Vec2 d = position - attractor.center;
    const double squared = d.squaredNorm();
    if (squared > attractor.range * attractor.range) return {0, 0};
    const double divisor = raised(softened(attractor, squared), attractor.power + 1);
    const double pull = attractor.strength / divisor;
    if (!std::isfinite(pull)) return {0, 0};  // at the centre, or so near that it overflows
    return -pull * d;
}

double potentialEnergy(const Attractor& attractor, const Vec2& position) {
    requireNumbers(attractor);
    if (attractor.strength == 0) return 0;
    const double squared = (position - attractor.center).squaredNorm();
    const double limit = attractor.range * attractor.range;
    if (squared > limit) return 0;
    const double energy = energyAt(attractor, softened(attractor, squared));
    if (!std::isfinite(attractor.range)) return energy;
    const double edge = std::isfinite(limit) ? softened(attractor, limit) : attractor.range;
    return energy - energyAt(attractor, edge);
}

}  // namespace plumb
