// SPDX-License-Identifier: MIT
#include <plumb/impact/impact.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSide(const ImpactSide& side, std::string_view field) {
    requireNotNegative(side.inverseMass, field, ".inverseMass");
    requireNotNegative(side.inverseInertia, field, ".inverseInertia");
    requireFinite(side.arm, field, ".arm");
}

ImpactResponse responseOf(const ImpactSide& a, const ImpactSide& b, const Vec2& normal) {
    const double sum = a.inverseMass + b.inverseMass;
    const double an = cross(a.arm, normal), bn = cross(b.arm, normal);
    const double at = cross(a.arm, perp(normal)), bt = cross(b.arm, perp(normal));
    return {sum + a.inverseInertia * an * an + b.inverseInertia * bn * bn,
            a.inverseInertia * an * at + b.inverseInertia * bn * bt,
            sum + a.inverseInertia * at * at + b.inverseInertia * bt * bt};
}

}  // namespace

// Every impulse that obeys the law of restitution is on a line, normal = (push - K_nt tangent) / K_nn. On it:
//   slip after  = slip0 + m tangent,  m = K_tt - K_nt^2 / K_nn >= 0
//   energy gain = normal (n + n') / 2 + tangent (t + t') / 2,  a parabola in tangent, <= 0 at tangent = 0
// So the tangential impulse is the one that stops the slip, limited by the friction cone and by the energy.
ImpactImpulses impactImpulses(const ImpactResponse& response, double approach, double slip, const ImpactLaw& law) {
    const ImpactResponse& k = response;
    const double push = (1 + law.restitution) * approach;
    const double slip0 = slip + k.coupling * push / k.normal;
    const double m = k.tangent - k.coupling * k.coupling / k.normal;
    // A pivot has m = 0: tangential impulses have no effect of their own. Rounding leaves about 1e-16 of it.
    if (!(m > 1e-12 * k.tangent) || law.friction == 0) return {push / k.normal, 0, false};

    double tangent = -slip0 / m;
    bool sticks = std::fabs(tangent) * k.normal <= law.friction * (push - k.coupling * tangent);
    if (!sticks) {
        // Larger friction makes no difference to the result, and infinite friction is allowed.
        const double friction = std::min(law.friction, 1e9);
        const double direction = tangent > 0 ? 1 : -1;
        tangent = direction * friction * push / (k.normal + direction * friction * k.coupling);
    }
    const double loss = 0.5 * (1 - law.restitution) * approach / k.normal;
    const double halfB = 0.25 * (slip + slip0) + 0.5 * loss * k.coupling;
    const double root = std::sqrt(halfB * halfB + 0.5 * m * loss * push);
    const double limit = 2 * (tangent > 0 ? std::max(0.0, root - halfB) : std::min(0.0, -root - halfB)) / m;
    if (std::fabs(tangent) > std::fabs(limit)) {
        tangent = limit;
        sticks = false;
    }
    return {(push - k.coupling * tangent) / k.normal, tangent, sticks};
}

ImpactResult impact(const ImpactSide& a, const ImpactSide& b, const Vec2& normal, const ImpactLaw& law) {
    requireWithin(law.restitution, 0, 1, "ImpactLaw", ".restitution");
    if (!(law.friction >= 0)) requireNotNegative(law.friction, "ImpactLaw", ".friction");
    requireFinite(law.surfaceSpeed, "ImpactLaw", ".surfaceSpeed");
    if (std::fabs(normal.squaredNorm() - 1) > 1e-5) refuse("impact: normal", toText(normal) + " is not a unit vector");
    requireSide(a, "ImpactSide a");
    requireSide(b, "ImpactSide b");

    ImpactResult result{.velocityA = a.velocity,
                        .velocityB = b.velocity,
                        .angularVelocityA = a.angularVelocity,
                        .angularVelocityB = b.angularVelocity};
    const Vec2 relative = b.velocity + b.angularVelocity * perp(b.arm) - a.velocity - a.angularVelocity * perp(a.arm);
    const double approach = -relative.dot(normal);
    const ImpactResponse k = responseOf(a, b, normal);
    if (!(approach > 0) || !std::isfinite(approach) || !(k.normal > 0)) return result;

    const ImpactImpulses j = impactImpulses(k, approach, relative.dot(perp(normal)) + law.surfaceSpeed, law);
    requireFinite(j.normal, "impact: normalImpulse");
    requireFinite(j.tangent, "impact: tangentImpulse");
    const Vec2 impulse = j.normal * normal + j.tangent * perp(normal);
    result.velocityA -= a.inverseMass * impulse;
    result.velocityB += b.inverseMass * impulse;
    result.angularVelocityA -= a.inverseInertia * cross(a.arm, impulse);
    result.angularVelocityB += b.inverseInertia * cross(b.arm, impulse);
    result.normalImpulse = j.normal;
    result.tangentImpulse = j.tangent;
    result.sticks = j.sticks;
    return result;
}

}  // namespace plumb
