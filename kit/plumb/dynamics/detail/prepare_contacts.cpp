// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/prepare_contacts.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

constexpr float justTouching = 1e-5f;  ///< [m]

/// One side of a contact: where its anchors count from, and how they are scaled.
struct Side {
    BodyIndex solver = noBody;
    float inverseMass = 0;
    float rho = 0;  ///< 0 for what is fixed: its anchors are of no account
};

Side sideOf(const WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    if (!record.awake) return {};
    return {body, static_cast<float>(record.inverseMass), record.rho};
}

/// Half the speed that gravity and forces can bring about between the two in the step. What comes in slower than this
/// was only pressed together, and what would part slower than this is back before the step is over.
double restingSpeed(const WorldState& world, const ContactRecord& contact, const Vec2& normal, double dt) {
    const auto pull = [&](BodyIndex body) {
        return std::fabs(accelerationOf(world.bodies.record[body], world.def.gravity).linear.dot(normal));
    };
    return 0.5 * dt * std::max(pull(contact.bodyA), pull(contact.bodyB));
}

double approachSpeed(const BodyMotion& a, const BodyMotion& b, const Vec2& ra, const Vec2& rb, const Vec2& normal) {
    const Vec2 va = a.velocity + perp(ra) * a.angularVelocity;
    const Vec2 vb = b.velocity + perp(rb) * b.angularVelocity;
    return (va - vb).dot(normal);
}

void prepareContact(WorldState& world, ContactRecord& contact, ContactBatch& batch, std::size_t lane, double dt) {
    const BodyMotion& ma = world.bodies.motion[contact.bodyA];
    const BodyMotion& mb = world.bodies.motion[contact.bodyB];
    const Side a = sideOf(world, contact.bodyA);
    const Side b = sideOf(world, contact.bodyB);
    const float cos = static_cast<float>(ma.rotation.cos);
    const float sin = static_cast<float>(ma.rotation.sin);
    const auto turn = [cos, sin](const Vec2f& v) -> Vec2f {
        return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
    };
    const Vec2f apart = Vec2(ma.center - mb.center).cast<float>();
    const Vec2f n = turn(contact.manifold.normal);
    const Vec2f t = perp(n);
    batch.bodyA[lane] = a.solver;
    batch.bodyB[lane] = b.solver;
    batch.normalX[lane] = n.x();
    batch.normalY[lane] = n.y();
    batch.friction[lane] = static_cast<float>(contact.friction);
    batch.roundA[lane] = a.rho * world.proxyA(contact).convex.radius;
    batch.roundB[lane] = b.rho * world.proxyB(contact).convex.radius;
    contact.approachSpeed = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        PointLanes& p = batch.points[i];
        p.totalNormal[lane] = p.totalTangent[lane] = p.solvedNormal[lane] = 0;
        if (static_cast<int>(i) >= contact.manifold.count) {
            p.normalMass[lane] = p.tangentMass[lane] = 0;
            p.normalImpulse[lane] = p.tangentImpulse[lane] = p.bounceSpeed[lane] = 0;
            p.startSeparation[lane] = p.separation[lane] = 0;
            continue;
        }
        const ManifoldPoint& point = contact.manifold.points[i];
        const Vec2f ra = turn(point.position);
        const Vec2f rb = ra + apart;
        p.anchorNormalA[lane] = a.rho * n.dot(ra);
        p.anchorTangentA[lane] = a.rho * t.dot(ra);
        p.anchorNormalB[lane] = b.rho * n.dot(rb);
        p.anchorTangentB[lane] = b.rho * t.dot(rb);
        const auto inverse = [&](float armA, float armB) {
            return a.inverseMass * (1 + armA * armA) + b.inverseMass * (1 + armB * armB);
        };
        p.normalMass[lane] = 1 / inverse(p.anchorTangentA[lane], p.anchorTangentB[lane]);
        p.tangentMass[lane] = 1 / inverse(p.anchorNormalA[lane], p.anchorNormalB[lane]);
        const Vec2 normal = n.cast<double>();
        const double approach = approachSpeed(ma, mb, ra.cast<double>(), rb.cast<double>(), normal);
        contact.approachSpeed = std::max(contact.approachSpeed, approach);
        const double resting = restingSpeed(world, contact, normal, dt);
        const double parting = contact.restitution * approach;
        p.bounceSpeed[lane] = parting > resting ? static_cast<float>(parting) : 0.0f;
        // What hits when it just touches is stopped hard, as what still has a gap is, and not by the soft push.
        const bool hits = approach > resting && point.separation > -justTouching;
        p.startSeparation[lane] = p.separation[lane] = hits ? std::max(point.separation, 1e-9f) : point.separation;
    }
}

}  // namespace

void prepareContacts(WorldState& world, double dt) {
    for (Colour& colour : world.graph.colours) {
        for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot) {
            ContactRecord& contact = world.contacts.contacts[colour.contactOf[slot]];
            prepareContact(world, contact, colour.batches[slot / batchLanes], slot % batchLanes, dt);
        }
    }
}

}  // namespace plumb
