// SPDX-License-Identifier: MIT
#include <plumb/stepping/interpolate.h>

#include <cmath>
#include <numbers>

#include <plumb/math/check.h>

namespace plumb {

double interpolate(double from, double to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * (to - from);
}

Vec2 interpolate(const Vec2& from, const Vec2& to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * (to - from);
}

double shortestTurn(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);  // exact by definition, so the same everywhere
}

double interpolateAngle(double from, double to, double fraction) {
    requireWithin(fraction, 0, 1, "fraction");
    return from + fraction * shortestTurn(from, to);
}

Transform interpolate(const Transform& from, const Transform& to, double fraction) {
    const Rot turn = from.rotation.inverse() * to.rotation;
    return {interpolate(from.position, to.position, fraction), from.rotation * Rot::fromAngle(fraction * turn.angle())};
}

}  // namespace plumb
