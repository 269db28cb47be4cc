// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/face_impact.h>

#include <algorithm>
#include <array>

#include <plumb/collide/manifold.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>

namespace plumb {

namespace {

/// The most sweeps over both points: enough for the impulses to converge [-]. Sweeps end earlier when no bit changes.
constexpr int mostSweeps = 200;

ImpactSide sideOf(const ImpactBody& body, const Vec2& point) {
    return {body.motion.velocity, body.motion.angularVelocity, body.inverseMass, body.inverseInertia,
            point - body.motion.center};
}

/// Solves two points together: each parts at the restitution times its own approach speed. A box that lands flat has
/// two equal points, and solving one after the other would set it spinning; so the impulses are summed for each point,
/// clamped in the sum, and corrected until both conditions hold. Source: projected Gauss-Seidel, as in Catto,
/// "Iterative dynamics with temporal coherence", GDC 2005.
class FaceImpact {
public:
    FaceImpact(const Vec2& normal, const ImpactLaw& law, ImpactBody& a, ImpactBody& b)
        : normal_(normal), law_(law), a_(a), b_(b) {}

    std::vector<PointImpulse> solve(std::span<const Vec2> points) {
        std::array<Impulse, 2> impulses;
        for (std::size_t i = 0; i < 2; ++i)
            impulses[i].wanted = -law_.restitution * std::min(speedAt(points[i]).dot(normal_), 0.0);
        for (int sweep = 0; sweep < mostSweeps; ++sweep) {
            const std::array<Impulse, 2> before = impulses;
            for (std::size_t i = 0; i < 2; ++i) solvePoint(points[i], impulses[i]);
            if (impulses == before) break;
        }
        std::vector<PointImpulse> given;
        for (std::size_t i = 0; i < 2; ++i) given.push_back({points[i], impulses[i].normal, impulses[i].tangent});
        return given;
    }

private:
    struct Impulse {
        double wanted = 0, normal = 0, tangent = 0;
        bool operator==(const Impulse&) const = default;
    };

    /// First the normal, then friction within its limit; sums are clamped, so a later sweep may take impulses back.
    void solvePoint(const Vec2& point, Impulse& impulse) {
        const double change = (impulse.wanted - speedAt(point).dot(normal_)) / inverseMass(point, normal_);
        const double normal = std::max(impulse.normal + change, 0.0);
        push(point, normal_ * (normal - impulse.normal));
        impulse.normal = normal;
        const Vec2 t = perp(normal_);
        const double limit = law_.friction * impulse.normal;
        const double slow = (speedAt(point).dot(t) + law_.surfaceSpeed) / inverseMass(point, t);
        const double tangent = std::clamp(impulse.tangent - slow, -limit, limit);
        push(point, t * (tangent - impulse.tangent));
        impulse.tangent = tangent;
    }

    /// The velocity of B relative to A at a point [m/s].
    Vec2 speedAt(const Vec2& point) const { return velocityAt(b_.motion, point) - velocityAt(a_.motion, point); }

    void push(const Vec2& point, const Vec2& impulse) {
        const ImpactSide sa = sideOf(a_, point);
        const ImpactSide sb = sideOf(b_, point);
        a_.motion.velocity = sa.velocity - impulse * sa.inverseMass;
        a_.motion.angularVelocity = sa.angularVelocity - cross(sa.arm, impulse) * sa.inverseInertia;
        b_.motion.velocity = sb.velocity + impulse * sb.inverseMass;
        b_.motion.angularVelocity = sb.angularVelocity + cross(sb.arm, impulse) * sb.inverseInertia;
    }

    double inverseMass(const Vec2& point, const Vec2& direction) const {
        const ImpactSide sa = sideOf(a_, point);
        const ImpactSide sb = sideOf(b_, point);
        const double ra = cross(sa.arm, direction);
        const double rb = cross(sb.arm, direction);
        return sa.inverseMass + ra * ra * sa.inverseInertia + sb.inverseMass + rb * rb * sb.inverseInertia;
    }

    Vec2 normal_;
    ImpactLaw law_;
    ImpactBody& a_;
    ImpactBody& b_;
};

}  // namespace

/// A disc has one point. Two faces count as parallel if their manifold has two points within the tolerance; else the
/// nearest points of both shapes are the only ones that touch.
std::vector<Vec2> touchingPoints(const Convex& a, const BodyMotion& motionA, const Convex& b, const BodyMotion& motionB,
                                 const Distance& where, double size) {
    const Vec2 middle = 0.5 * (where.pointA + where.pointB);
    if (a.count == 1 || b.count == 1) return {middle};
    const double faceTolerance = 1e-5 * size;  // the manifold is computed in floats
    const Manifold m = manifold(a, b, relativePose(motionA, motionB), static_cast<float>(faceTolerance));
    if (m.count < 2) return {middle};
    std::vector<Vec2> points;
    for (const ManifoldPoint& p : m.points)
        points.push_back(motionA.center + motionA.rotation * Vec2(p.position.cast<double>()));
    return points;
}

/// One point has a closed form, which treats slip and stick exactly (impact/impact.h); two have none, and are iterated.
std::vector<PointImpulse> solveImpact(std::span<const Vec2> points, const Vec2& normal, const ImpactLaw& law,
                                      ImpactBody& a, ImpactBody& b) {
    if (points.size() == 2) return FaceImpact(normal, law, a, b).solve(points);
    const ImpactResult result = impact(sideOf(a, points[0]), sideOf(b, points[0]), normal, law);
    a.motion.velocity = result.velocityA;
    a.motion.angularVelocity = result.angularVelocityA;
    b.motion.velocity = result.velocityB;
    b.motion.angularVelocity = result.angularVelocityB;
    return {{points[0], result.normalImpulse, result.tangentImpulse}};
}

}  // namespace plumb
