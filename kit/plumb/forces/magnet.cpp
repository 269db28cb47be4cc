// SPDX-License-Identifier: MIT
#include <plumb/forces/magnet.h>

#include <cmath>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const Magnetism& law) {
    requireNotNegative(law.constant, "Magnetism", ".constant");
    requireNotNegative(law.softening, "Magnetism", ".softening");
}

/// K / q^3 [N/A^2/m^3], and 1 / q^2; both 0 at the same position, or so near that they overflow.
struct Nearness {
    double strength = 0, inverseSquare = 0;
};

Nearness nearnessOf(const Magnetism& law, const Vec2& d) {
    const double square = d.squaredNorm() + law.softening * law.softening;
    const double fifth = square * square * std::sqrt(square);
    if (fifth == 0) return {};
    return {law.constant / (square * std::sqrt(square)), 1 / square};
}

/// The field of A at the displacement d from it [T].
Vec2 fieldAt(const Nearness& near, const Vec2& moment, const Vec2& d) {
    return near.strength * (3 * near.inverseSquare * moment.dot(d) * d - moment);
}

}  // namespace

MagnetPull magnetPull(const Magnetism& law, const Dipole& a, const Dipole& b) {
    requireSound(law);
    const Vec2 d = b.position - a.position;
    const Nearness near = nearnessOf(law, d);
    const double along = a.moment.dot(d), alongB = b.moment.dot(d);
    const double radial = a.moment.dot(b.moment) - 5 * near.inverseSquare * along * alongB;
    const Vec2 sum = radial * d + alongB * a.moment + along * b.moment;
    return {3 * near.strength * near.inverseSquare * sum, cross(b.moment, fieldAt(near, a.moment, d))};
}

double potentialEnergy(const Magnetism& law, const Dipole& a, const Dipole& b) {
    requireSound(law);
    const Vec2 d = b.position - a.position;
    return -b.moment.dot(fieldAt(nearnessOf(law, d), a.moment, d));
}

}  // namespace plumb
