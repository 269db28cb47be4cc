// SPDX-License-Identifier: MIT
#include <plumb/impact/rolling.h>

#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

void requireSound(const SlidingDisc& disc) {
    requireFinite(disc.speed, "SlidingDisc", ".speed");
    requireFinite(disc.angularVelocity, "SlidingDisc", ".angularVelocity");
    requirePositive(disc.radius, "SlidingDisc", ".radius");
    requirePositive(disc.inertiaRatio, "SlidingDisc", ".inertiaRatio");
    requireNotNegative(disc.friction, "SlidingDisc", ".friction");
    requirePositive(disc.gravity, "SlidingDisc", ".gravity");
}

}  // namespace

std::optional<Rolling> slideToRoll(const SlidingDisc& disc) {
    requireSound(disc);
    const double k = disc.inertiaRatio, turn = disc.angularVelocity * disc.radius;
    const double slip = disc.speed + turn;
    // Rolling up to the rounding of r, w r and v: half a unit in the last place each.
    if (std::fabs(slip) <= 2e-16 * (std::fabs(disc.speed) + std::fabs(turn)))
        return Rolling{0, 0, disc.speed, disc.angularVelocity};
    if (disc.friction == 0) return std::nullopt;
    const double time = std::fabs(slip) * k / ((1 + k) * disc.friction * disc.gravity);
    const double speed = (disc.speed - k * turn) / (1 + k);
    return Rolling{time, (disc.speed + speed) / 2 * time, speed, -speed / disc.radius};
}

Descent rollDown(const Incline& incline) {
    requireWithin(incline.angle, 0, std::numbers::pi / 2, "Incline", ".angle");
    requirePositive(incline.inertiaRatio, "Incline", ".inertiaRatio");
    requireNotNegative(incline.friction, "Incline", ".friction");
    requirePositive(incline.gravity, "Incline", ".gravity");
    const SinCos slope = sinCos(incline.angle);
    const double k = incline.inertiaRatio, g = incline.gravity;
    const double most = incline.friction * slope.cos;
    if (most >= slope.sin * (k / (1 + k))) {
        const double rolling = g * slope.sin / (1 + k);
        return {rolling, rolling, true};
    }
    return {g * (slope.sin - most), g * most / k, false};
}

double frictionToRoll(double angle, double inertiaRatio) {
    requireWithin(angle, 0, std::numbers::pi / 2, "frictionToRoll: angle");
    requirePositive(inertiaRatio, "frictionToRoll: inertiaRatio");
    const SinCos slope = sinCos(angle);
    return slope.sin / slope.cos * (inertiaRatio / (1 + inertiaRatio));
}

}  // namespace plumb
