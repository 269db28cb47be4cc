// SPDX-License-Identifier: MIT
#include <plumb/impact/discs.h>

#include <plumb/math/check.h>

namespace plumb {
namespace {

/// normal: away from the disc's centre, to the point.
ImpactSide sideOf(const Disc& disc, const Vec2& normal, std::string_view field) {
    requirePositive(disc.radius, field, ".radius");
    requirePositive(disc.inertiaRatio, field, ".inertiaRatio");
    if (!(disc.mass > 0)) requirePositive(disc.mass, field, ".mass");
    return {.velocity = disc.velocity,
            .angularVelocity = disc.angularVelocity,
            .inverseMass = 1 / disc.mass,
            .inverseInertia = 1 / (disc.mass * disc.inertiaRatio * disc.radius * disc.radius),
            .arm = disc.radius * normal};
}

}  // namespace

ImpactResult collideDiscs(const Disc& a, const Disc& b, const ImpactLaw& law) {
    const Vec2 between = b.position - a.position;
    const double distance = between.norm();
    if (distance == 0)
        return {.velocityA = a.velocity,
                .velocityB = b.velocity,
                .angularVelocityA = a.angularVelocity,
                .angularVelocityB = b.angularVelocity};
    const Vec2 normal = between / distance;
    return impact(sideOf(a, normal, "Disc a"), sideOf(b, -normal, "Disc b"), normal, law);
}

ImpactResult collideWithWall(const Disc& disc, const ImpactWall& wall, const ImpactLaw& law) {
    return impact({.velocity = wall.velocity}, sideOf(disc, -wall.normal, "Disc"), wall.normal, law);
}

}  // namespace plumb
