// SPDX-License-Identifier: MIT
#include <plumb/impact/discs.h>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>

namespace plumb {
namespace {

/// normal: from the disc's centre to the contact point.
ImpactSide sideOf(const Disc& disc, const Vec2& normal, std::string_view field) {
    requirePositive(disc.radius, field, ".radius");
    requirePositive(disc.inertiaRatio, field, ".inertiaRatio");
    if (!(disc.mass > 0)) requirePositive(disc.mass, field, ".mass");
    requireFinite(disc.velocity, field, ".velocity");
    requireFinite(disc.angularVelocity, field, ".angularVelocity");
    return {.velocity = disc.velocity,
            .angularVelocity = disc.angularVelocity,
            .inverseMass = 1 / disc.mass,
            .inverseInertia = 1 / (disc.mass * disc.inertiaRatio * disc.radius * disc.radius),
            .arm = disc.radius * normal};
}

}  // namespace

ImpactResult collideDiscs(const Disc& a, const Disc& b, const ImpactLaw& law) {
    requireFinite(a.position, "Disc a", ".position");
    requireFinite(b.position, "Disc b", ".position");
    const Vec2 normal = detail::directionOf(0.5 * b.position - 0.5 * a.position);
    const ImpactSide sideA = sideOf(a, normal, "Disc a"), sideB = sideOf(b, -normal, "Disc b");
    if (normal.isZero(0))
        return {.velocityA = a.velocity,
                .velocityB = b.velocity,
                .angularVelocityA = a.angularVelocity,
                .angularVelocityB = b.angularVelocity};
    return impact(sideA, sideB, normal, law);
}

ImpactResult collideWithWall(const Disc& disc, const ImpactWall& wall, const ImpactLaw& law) {
    requireFinite(wall.velocity, "ImpactWall", ".velocity");
    return impact({.velocity = wall.velocity}, sideOf(disc, -wall.normal, "Disc"), wall.normal, law);
}

}  // namespace plumb
