// SPDX-License-Identifier: MIT
#include <plumb/impact/particles.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <plumb/math/check.h>

namespace plumb {
namespace {

ImpactSide sideOf(const Particle& particle, std::string_view field) {
    if (!(particle.mass > 0)) requirePositive(particle.mass, field, ".mass");
    requireFinite(particle.velocity, field, ".velocity");
    return {.velocity = particle.velocity, .inverseMass = 1 / particle.mass};
}

}  // namespace

ImpactResult collideParticles(const Particle& a, const Particle& b, const Vec2& normal, const ImpactLaw& law) {
    return impact(sideOf(a, "Particle a"), sideOf(b, "Particle b"), normal, law);
}

Vec2 bounceOffWall(const Vec2& velocity, const Vec2& normal, const ImpactLaw& law) {
    requireFinite(velocity, "bounceOffWall: velocity");
    return impact({}, {.velocity = velocity, .inverseMass = 1}, normal, law).velocityB;
}

LineImpact collideInLine(const LineParticle& a, const LineParticle& b, double restitution) {
    const ImpactResult result =
        collideParticles({a.mass, {a.velocity, 0}}, {b.mass, {b.velocity, 0}}, {1, 0}, {.restitution = restitution});
    return {result.velocityA.x(), result.velocityB.x(), result.normalImpulse};
}

RowImpact collideRow(std::span<const LineParticle> row, double restitution, int maxImpacts) {
    requireWithin(restitution, 0, 1, "collideRow: restitution");
    if (maxImpacts < 0) refuse("collideRow: maxImpacts", std::to_string(maxImpacts) + " is negative");
    RowImpact result;
    double largest = 0;
    for (const LineParticle& particle : row) {
        if (!(particle.mass > 0)) requirePositive(particle.mass, "LineParticle", ".mass");
        requireFinite(particle.velocity, "LineParticle", ".velocity");
        result.velocities.push_back(particle.velocity);
        largest = std::max(largest, std::fabs(particle.velocity));
    }
    std::vector<double>& v = result.velocities;
    // Sweep after sweep. Going back to the left after each impact instead would let three particles that come to rest
    // among themselves, by very many impacts, delay all others.
    for (bool calm = false; !calm;) {
        calm = true;
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            if (!(v[i] - v[i + 1] > 1e-12 * largest)) continue;
            if (result.impacts == maxImpacts) {
                result.parted = false;
                return result;
            }
            const LineImpact hit = collideInLine({row[i].mass, v[i]}, {row[i + 1].mass, v[i + 1]}, restitution);
            v[i] = hit.velocityA;
            v[i + 1] = hit.velocityB;
            ++result.impacts;
            calm = false;
        }
    }
    return result;
}

}  // namespace plumb
