// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/contact_lane.h>

#include <algorithm>

#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/contacts/lanes/point_kinematics.h>

namespace plumb {

namespace {

/// An impulse that the contact's record remembers, times this, is one of the present step. Impulses that hold a load
/// grow with the length of the step. Test: "towers stand for a minute while the step's length changes"
float memoryRatio(const ContactRecord& contact, const BodyStore& bodies) {
    return contact.memoryStep > 0 ? static_cast<float>(bodies.lastSolved / contact.memoryStep) : 1.0f;
}

/// rollMass = 1 / (1/IA + 1/IB) [kg m^2], I moments of inertia: the torque impulse that stops a relative spin of 1
/// rad/s.
void fillRolling(ContactBatch& batch, std::size_t lane, const ContactRecord& contact, const BodyStore& bodies) {
    const BodyRecord& a = bodies.record[contact.bodyA];
    const BodyRecord& b = bodies.record[contact.bodyB];
    const float inverse = static_cast<float>(a.inverseInertia + b.inverseInertia);
    batch.rollingArm[lane] = inverse > 0 ? contact.rollingArm : 0.0f;
    batch.rollInverseGyrationA[lane] = a.inverseGyration;
    batch.rollInverseGyrationB[lane] = b.inverseGyration;
    batch.rollMass[lane] = inverse > 0 ? 1 / inverse : 0.0f;
    batch.rollImpulse[lane] = contact.rollImpulse * memoryRatio(contact, bodies);
}

}  // namespace

void fillLane(ContactBatch& batch, ManifoldLanes& manifolds, std::size_t lane, const ContactRecord& contact,
              const BodyStore& bodies, const Space& space) {
    batch.bodyA[lane] = contact.bodyA;
    batch.bodyB[lane] = contact.bodyB;
    batch.friction[lane] = static_cast<float>(contact.friction);
    batch.roundA[lane] = bodies.record[contact.bodyA].inverseGyration * space[contact.proxyA].convex.radius;
    batch.roundB[lane] = bodies.record[contact.bodyB].inverseGyration * space[contact.proxyB].convex.radius;
    batch.surfaceSpeed[lane] = contact.surfaceSpeed;
    fillRolling(batch, lane, contact, bodies);
    manifolds.restitution[lane] = static_cast<float>(contact.restitution);
    manifolds.touching[lane] = contact.touching ? 1 : 0;
    manifolds.count[lane] = contact.manifold.count;
    const float ratio = memoryRatio(contact, bodies);
    for (std::size_t p = 0; p < 2; ++p) {
        const ManifoldPoint& point = contact.manifold.points[p];
        manifolds.points[p].x[lane] = point.position.x();
        manifolds.points[p].y[lane] = point.position.y();
        manifolds.points[p].feature[lane] = point.feature;
        batch.points[p].normalImpulse[lane] = contact.memory[p].normalImpulse * ratio;
        batch.points[p].tangentImpulse[lane] = contact.memory[p].tangentImpulse * ratio;
    }
}

void setFresh(FreshLanes& fresh, std::size_t lane, const Manifold& manifold) {
    fresh.normalX[lane] = manifold.normal.x();
    fresh.normalY[lane] = manifold.normal.y();
    fresh.count[lane] = manifold.count;
    fresh.uncertain[lane] = 0;
    fresh.inset[lane] = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        const ManifoldPoint& point = manifold.points[p];
        fresh.points[p].x[lane] = point.position.x();
        fresh.points[p].y[lane] = point.position.y();
        fresh.points[p].separation[lane] = point.separation;
        fresh.points[p].feature[lane] = point.feature;
    }
}

Manifold manifoldAt(const FreshLanes& fresh, std::size_t lane) {
    Manifold manifold;
    manifold.normal = {fresh.normalX[lane], fresh.normalY[lane]};
    manifold.count = fresh.count[lane];
    for (std::size_t p = 0; p < 2; ++p) {
        const FreshPoint& point = fresh.points[p];
        manifold.points[p] = {{point.x[lane], point.y[lane]}, point.separation[lane], 0};
    }
    return manifold;
}

float nearestOf(const FreshLanes& fresh, std::size_t lane) {
    const float first = fresh.points[0].separation[lane];
    return fresh.count[lane] > 1 ? std::min(first, fresh.points[1].separation[lane]) : first;
}

namespace {

/// Anchors and rounding radii are stored times rho: they change with it.
void scaleSide(ContactBatch& batch, std::size_t lane, bool isA, float ratio) {
    for (PointLanes& p : batch.points) {
        (isA ? p.anchorNormalA : p.anchorNormalB)[lane] *= ratio;
        (isA ? p.anchorTangentA : p.anchorTangentB)[lane] *= ratio;
    }
    (isA ? batch.roundA : batch.roundB)[lane] *= ratio;
    (isA ? batch.rollInverseGyrationA : batch.rollInverseGyrationB)[lane] *= ratio;
}

/// The effective masses of the contact in a lane (formula in point_kinematics.h). A mass of 0 says that there is no
/// such point, and stays 0.
void findMasses(ContactBatch& batch, std::size_t lane, const std::vector<SolverVelocity>& velocity) {
    const float a = velocity[batch.bodyA[lane]].inverseMass, b = velocity[batch.bodyB[lane]].inverseMass;
    for (PointLanes& p : batch.points) {
        const LaneArms<1> arms = LaneArms<1>::of(p, static_cast<int>(lane));
        if (p.normalMass[lane] > 0) p.normalMass[lane] = 1 / arms.normalInverse(a, b);
        if (p.tangentMass[lane] > 0) p.tangentMass[lane] = 1 / arms.tangentInverse(a, b);
    }
    const float rollA = batch.rollInverseGyrationA[lane], rollB = batch.rollInverseGyrationB[lane];
    if (batch.rollMass[lane] > 0) batch.rollMass[lane] = 1 / (a * rollA * rollA + b * rollB * rollB);
}

}  // namespace

/// For bodies of joint islands: a contact that pushes a wheel moves the cart, so it sees the mass with which the island
/// responds (jointed/joint_contacts.cpp). The solver puts the body's own mass back when it stores the body. O(contacts
/// of the body).
void setSolverMass(ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies, BodyIndex body,
                   float inverseMass, float inverseGyration) {
    SolverTurn& turn = bodies.turn[body];
    // omega must stay, but w = omega / rho: w, and the sine of the turn, are stored over rho and change with 1 / ratio.
    // The impulses behind warm stay, too: the velocity that they have changed grows with the inverse mass, the spin
    // also with rho.
    const float ratio = turn.inverseGyration > 0 ? inverseGyration / turn.inverseGyration : 1.0f;
    SolverVelocity &v = bodies.velocity[body], &warm = bodies.warm[body];
    const float share = inverseMass / v.inverseMass;
    v.w /= ratio;
    bodies.before[body].w /= ratio;
    v.inverseMass = inverseMass;
    warm = {warm.x * share, warm.y * share, warm.w * share * ratio, 0};
    SolverDisplacement& moved = bodies.displacement[body];
    moved.sin /= ratio;
    moved.cosMinus1 /= ratio;
    bodies.kick[body].gain.w /= ratio;
    turn.inverseGyration *= ratio;
    turn.gyration /= ratio;
    forEachContact(bodies, contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = contacts[index];
        if (!contact.isSolved()) return;
        const ContactLane at = graph.laneOf(contact);
        scaleSide(at.batch, at.lane, contact.bodyA == body, ratio);
        findMasses(at.batch, at.lane, bodies.velocity);
    });
}

namespace {

/// Number of sweeps over the points of a single contact [-]; each sweep leaves a quarter of the error, so that eight
/// leave 2e-5 of it. Without a guess, the turn that the first sweeps leave is not taken back.
constexpr int sweeps = 8;

/// Points with a separation up to this carry load [m].
constexpr float loadedSeparation = 1e-4f;

/// The velocity change by the body's acceleration in half a sub-step [m/s]: pull is that of half a step.
SolverVelocity kickOf(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    const float share = 1 / static_cast<float>(bodies.subSteps);
    return {place.pullX * share, place.pullY * share, 0, bodies.velocity[body].inverseMass};
}

bool isNew(const ContactBatch& batch, std::size_t lane) {
    for (const PointLanes& p : batch.points)
        if (p.normalImpulse[lane] != 0 || p.tangentImpulse[lane] != 0) return false;
    return true;
}

/// A copy of the batch in which no two lanes share a body. Points that carry no load have zero effective mass.
ContactBatch withBodiesApart(const ContactBatch& batch) {
    ContactBatch own = batch;
    for (std::uint32_t lane = 0; lane < batchLanes; ++lane) {
        own.bodyA[lane] = 2 * lane;
        own.bodyB[lane] = 2 * lane + 1;
        for (PointLanes& p : own.points) {
            if (p.separation[lane] > loadedSeparation) p.normalMass[lane] = p.tangentMass[lane] = 0;
            p.separation[lane] = 0;
        }
    }
    return own;
}

}  // namespace

void guessImpulses(ContactBatch& batch, const BodyStore& bodies, int lanes) {
    SolverVelocity velocity[2 * batchLanes];
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        velocity[2 * lane] = kickOf(bodies, batch.bodyA[lane]);
        velocity[2 * lane + 1] = kickOf(bodies, batch.bodyB[lane]);
    }
    ContactBatch own = withBodiesApart(batch);
    SolverBodies alone;
    alone.velocity = velocity;
    // No bias and no compliance: the guess is a force, and takes no part in pushing overlap out.
    const ContactPass rigid{0, {0, 1, 0}, 0};
    for (int i = 0; i < sweeps; ++i) contactSolver(lanes).solve(&own, batchLanes, alone, rigid);
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        // What has impulses from an earlier touch knows its neighbours already; the guess does not.
        if (!isNew(batch, lane)) continue;
        for (std::size_t p = 0; p < 2; ++p) {
            batch.points[p].normalImpulse[lane] = own.points[p].normalImpulse[lane];
            batch.points[p].tangentImpulse[lane] = own.points[p].tangentImpulse[lane];
        }
    }
}

}  // namespace plumb
