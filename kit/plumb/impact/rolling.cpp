// SPDX-License-Identifier: MIT
#include <plumb/impact/rolling.h>

#include <cmath>

#include <plumb/math/check.h>

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
    if (slip == 0) return Rolling{0, 0, disc.speed, disc.angularVelocity};
    if (disc.friction == 0) return std::nullopt;
    const double time = std::fabs(slip) * k / ((1 + k) * disc.friction * disc.gravity);
    const double speed = (disc.speed - k * turn) / (1 + k);
    return Rolling{time, (disc.speed + speed) / 2 * time, speed, -speed / disc.radius};
}

}  // namespace plumb
