// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/lanes/contact_solver.h>

#include <plumb/dynamics/contacts/lanes/two_points.h>

namespace plumb {

namespace {

/// The two bodies of one lane, and the contact's normal.
struct BodyPair {
    SolverVelocity a, b;
    float nx, ny;
};

/// The copies are solved and stored back at the lane's end. A wall's copy does not change: its inverse mass is 0.
BodyPair load(const ContactBatch& batch, std::size_t lane, const SolverVelocity* velocity) {
    return {velocity[batch.bodyA[lane]], velocity[batch.bodyB[lane]], batch.normalX[lane], batch.normalY[lane]};
}

void store(const ContactBatch& batch, std::size_t lane, const BodyPair& c, SolverVelocity* velocity) {
    velocity[batch.bodyA[lane]] = c.a;
    velocity[batch.bodyB[lane]] = c.b;
}

/// vn of contact_solver.h: positive where the points part [m/s].
float normalSpeed(const BodyPair& c, const PointLanes& p, std::size_t lane) {
    return (c.nx * (c.b.x - c.a.x) + c.ny * (c.b.y - c.a.y)) +
           (p.anchorTangentA[lane] * c.a.w - p.anchorTangentB[lane] * c.b.w);
}

/// vt of contact_solver.h, without the belt [m/s].
float tangentSpeed(const BodyPair& c, const PointLanes& p, std::size_t lane) {
    return (c.nx * (c.b.y - c.a.y) - c.ny * (c.b.x - c.a.x)) +
           (p.anchorNormalB[lane] * c.b.w - p.anchorNormalA[lane] * c.a.w);
}

/// An impulse at a point along the normal, on B, and the opposite one on A [N s]. One product with the inverse mass
/// serves shift and spin, as w = omega / rho (see SolverVelocity). pushTangent is the same along perp(n).
void pushNormal(BodyPair& c, const PointLanes& p, std::size_t lane, float impulse) {
    const float ja = c.a.inverseMass * impulse;
    const float jb = c.b.inverseMass * impulse;
    c.a.x -= ja * c.nx;
    c.a.y -= ja * c.ny;
    c.a.w += ja * p.anchorTangentA[lane];
    c.b.x += jb * c.nx;
    c.b.y += jb * c.ny;
    c.b.w -= jb * p.anchorTangentB[lane];
}

void pushTangent(BodyPair& c, const PointLanes& p, std::size_t lane, float impulse) {
    const float ja = c.a.inverseMass * impulse;
    const float jb = c.b.inverseMass * impulse;
    c.a.x += ja * c.ny;
    c.a.y -= ja * c.nx;
    c.a.w -= ja * p.anchorNormalA[lane];
    c.b.x -= jb * c.ny;
    c.b.y += jb * c.nx;
    c.b.w += jb * p.anchorNormalB[lane];
}

/// A torque impulse on B, and the opposite one on A [N m s].
void twist(BodyPair& c, const ContactBatch& batch, std::size_t lane, float impulse) {
    c.a.w -= c.a.inverseMass * (batch.rollInverseGyrationA[lane] * impulse);
    c.b.w += c.b.inverseMass * (batch.rollInverseGyrationB[lane] * impulse);
}

/// s = s0 + n.(dB - dA) + (n.r)(c - 1) - (t.r) sin for B, minus the same for A. Here r reaches only to the shape
/// without its rounding: while a disc rolls, its lowest point is always a different one, so only its centre's motion
/// counts.
float separationNow(const ContactBatch& batch, const PointLanes& p, std::size_t lane,
                    const SolverDisplacement* displacement) {
    const SolverDisplacement& a = displacement[batch.bodyA[lane]];
    const SolverDisplacement& b = displacement[batch.bodyB[lane]];
    const float shift = batch.normalX[lane] * (b.x - a.x) + batch.normalY[lane] * (b.y - a.y);
    const float innerA = p.anchorNormalA[lane] - batch.roundA[lane];
    const float innerB = p.anchorNormalB[lane] + batch.roundB[lane];
    const float turnA = innerA * a.cosMinus1 - p.anchorTangentA[lane] * a.sin;
    const float turnB = innerB * b.cosMinus1 - p.anchorTangentB[lane] * b.sin;
    return p.startSeparation[lane] + (shift + (turnB - turnA));
}

using Solved = ContactImpulses;

using Points = TwoPoints<float>;

Points pointsOf(const BodyPair& c, const ContactBatch& batch, std::size_t lane) {
    const PointLanes &p = batch.points[0], &q = batch.points[1];
    return Points::of({{p.normalMass[lane], q.normalMass[lane]}}, c.a.inverseMass, c.b.inverseMass,
                      {{p.anchorTangentA[lane], q.anchorTangentA[lane]}},
                      {{p.anchorTangentB[lane], q.anchorTangentB[lane]}});
}

/// find(i) for both points.
template <class Find>
Points::Each each(Find&& find) {
    return {{find(0), find(1)}};
}

/// Replaces the impulses of both points: the velocities change by the difference. So the sum of all passes stays
/// limited, not each change (accumulated impulses).
void setNormals(BodyPair& c, ContactBatch& batch, std::size_t lane, const Points::Each& now) {
    for (int i = 0; i < 2; ++i) {
        PointLanes& p = batch.points[i];
        const float change = now.at[i] - p.normalImpulse[lane];
        p.normalImpulse[lane] = now.at[i];
        pushNormal(c, p, lane, change);
    }
}

void setTangents(BodyPair& c, ContactBatch& batch, std::size_t lane, const Points::Each& now) {
    for (int i = 0; i < 2; ++i) {
        PointLanes& p = batch.points[i];
        const float change = now.at[i] - p.tangentImpulse[lane];
        p.tangentImpulse[lane] = now.at[i];
        pushTangent(c, p, lane, change);
    }
}

/// A torque against rolling on each other, limited to rollingArm times the normal impulse: the resistance of a wheel
/// that is pressed flat. Test: "a disc with rolling resistance 0.2 slows down at 2/3 0.2 g = 1.308 m/s^2 and stands
/// after 1.53 s"
void solveRolling(BodyPair& c, ContactBatch& batch, std::size_t lane, const Solved& solved) {
    const float old = batch.rollImpulse[lane];
    const float normal = (solved.normal[0] + batch.points[0].normalImpulse[lane]) +
                         (solved.normal[1] + batch.points[1].normalImpulse[lane]);
    const float limit = batch.rollingArm[lane] * normal;
    const float speed = batch.rollInverseGyrationB[lane] * c.b.w - batch.rollInverseGyrationA[lane] * c.a.w;
    const float wanted = old - batch.rollMass[lane] * speed;
    const float now = larger(smaller(wanted, limit - solved.roll), -limit - solved.roll);
    batch.rollImpulse[lane] = now;
    twist(c, batch, lane, now - old);
}

/// After the normal impulses, so that the limit is known even in a contact's first sub-step: friction of both halves
/// together is limited to mu times the normal impulse of both (Coulomb's cone).
void solveAlong(BodyPair& c, ContactBatch& batch, std::size_t lane, const Solved& solved) {
    const float belt = batch.hasSurfaceSpeed ? batch.surfaceSpeed[lane] : 0.0f;
    const auto point = [&](int i) -> const PointLanes& { return batch.points[i]; };
    setTangents(c, batch, lane,
                Points::tangents(each([&](int i) { return point(i).tangentMass[lane]; }),
                                 each([&](int i) { return point(i).tangentImpulse[lane]; }),
                                 {{solved.tangent[0], solved.tangent[1]}},
                                 each([&](int i) { return tangentSpeed(c, point(i), lane) + belt; }), each([&](int i) {
                                     return batch.friction[lane] * (solved.normal[i] + point(i).normalImpulse[lane]);
                                 })));
    if (batch.hasRollingResistance) solveRolling(c, batch, lane, solved);
}

template <class Batch, class Visit>
void forEachLane(Batch* batches, std::size_t contacts, Visit&& visit) {
    for (std::size_t i = 0; i < contacts; ++i) visit(batches[i / batchLanes], i % batchLanes);
}

/// Once a step, before the first sub-step. Bodies gather the velocity changes by the impulses of all their contacts,
/// and kickBodies applies them in each half: so the contacts are not passed again for that.
void gatherWarmStart(const ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies) {
    forEachLane(batches, contacts, [&](const ContactBatch& batch, std::size_t lane) {
        BodyPair pair = load(batch, lane, bodies.warm);
        pair.a.inverseMass = bodies.velocity[batch.bodyA[lane]].inverseMass;
        pair.b.inverseMass = bodies.velocity[batch.bodyB[lane]].inverseMass;
        for (const PointLanes& p : batch.points) {
            pushNormal(pair, p, lane, p.normalImpulse[lane]);
            pushTangent(pair, p, lane, p.tangentImpulse[lane]);
        }
        if (batch.hasRollingResistance) twist(pair, batch, lane, batch.rollImpulse[lane]);
        // warm is added to velocity as a whole, which must keep its inverse mass.
        pair.a.inverseMass = pair.b.inverseMass = 0;
        store(batch, lane, pair, bodies.warm);
    });
}

void solve(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies, const ContactPass& pass) {
    forEachLane(batches, contacts,
                [&](ContactBatch& batch, std::size_t lane) { solveLane(batch, lane, bodies, pass); });
}

/// The second half of a sub-step. kickBodies has applied the impulses of the first half once more, as a guess; here the
/// sum of both halves is limited to a push, so the second half may take back what the first half gave to correct
/// positions. Where a gap is left, the points may close it within h, and no faster.
void relaxPoints(BodyPair& c, ContactBatch& batch, std::size_t lane, const ContactPass& pass, const Solved& solved) {
    const Points::Each total =
        pointsOf(c, batch, lane)
            .normals(each([&](int i) { return solved.normal[i] + batch.points[i].normalImpulse[lane]; }),
                     each([&](int i) {
                         const PointLanes& p = batch.points[i];
                         return normalSpeed(c, p, lane) + larger(p.separation[lane], 0.0f) * pass.inverseStep;
                     }),
                     {{1, 1}});
    setNormals(c, batch, lane, each([&](int i) { return total.at[i] - solved.normal[i]; }));
    solveAlong(c, batch, lane, solved);
}

/// The impulses of both halves count for events, friction loads and bounces. pushed tells storeBodies that the two
/// bodies do not fly freely.
void addTotals(ContactBatch& batch, std::size_t lane, const Solved& solved) {
    for (int i = 0; i < 2; ++i) {
        PointLanes& p = batch.points[i];
        p.totalNormal[lane] = solved.totalNormal[i] + (solved.normal[i] + p.normalImpulse[lane]);
        p.totalTangent[lane] = solved.totalTangent[i] + (solved.tangent[i] + p.tangentImpulse[lane]);
        if (solved.normal[i] > 0 || p.normalImpulse[lane] > 0) batch.pushed[lane] = -1;
    }
}

void relax(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies, const ContactPass& pass) {
    forEachLane(batches, contacts, [&](ContactBatch& batch, std::size_t lane) {
        BodyPair pair = load(batch, lane, bodies.velocity);
        const Solved solved = impulsesOf(batch, lane);  // the impulses of solve, applied a second time as a first guess
        for (PointLanes& p : batch.points) p.separation[lane] = separationNow(batch, p, lane, bodies.displacement);
        relaxPoints(pair, batch, lane, pass, solved);
        addTotals(batch, lane, solved);
        store(batch, lane, pair, bodies.velocity);
    });
}

/// Once, at the step's end: the points part at e times their approach at the step's start, but only where they have
/// pushed, so that what was only near does not bounce. As before, it is the sum of a point's impulses that may not
/// pull.
void bounce(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies) {
    forEachLane(batches, contacts, [&](ContactBatch& batch, std::size_t lane) {
        if (!batch.bounces) return;
        BodyPair pair = load(batch, lane, bodies.velocity);
        Points points = pointsOf(pair, batch, lane);
        const auto bounces = [&](int i) {
            return batch.points[i].bounceSpeed[lane] > 0 && batch.points[i].totalNormal[lane] > 0;
        };
        // A point that does not bounce takes no part: its impulse stays what it was.
        points.coupling = bounces(0) && bounces(1) ? points.coupling : 0;
        points.freedom = bounces(0) && bounces(1) ? points.freedom : 1;
        const Points::Each old = each([&](int i) { return batch.points[i].totalNormal[lane]; });
        const Points::Each now = points.normals(old, each([&](int i) {
                                                    const PointLanes& p = batch.points[i];
                                                    return normalSpeed(pair, p, lane) - p.bounceSpeed[lane];
                                                }),
                                                {{1, 1}});
        for (int i = 0; i < 2; ++i) {
            const float total = bounces(i) ? now.at[i] : old.at[i];
            batch.points[i].totalNormal[lane] = total;
            pushNormal(pair, batch.points[i], lane, total - old.at[i]);
        }
        store(batch, lane, pair, bodies.velocity);
    });
}

}  // namespace

ContactImpulses impulsesOf(const ContactBatch& batch, std::size_t lane) {
    ContactImpulses solved;
    solved.roll = batch.hasRollingResistance ? batch.rollImpulse[lane] : 0.0f;
    for (int i = 0; i < 2; ++i) {
        solved.normal[i] = batch.points[i].normalImpulse[lane];
        solved.tangent[i] = batch.points[i].tangentImpulse[lane];
        solved.totalNormal[i] = batch.points[i].totalNormal[lane];
        solved.totalTangent[i] = batch.points[i].totalTangent[lane];
    }
    return solved;
}

/// For contacts of joint islands, which are solved again after their joints have changed (jointed/joint_contacts.cpp).
/// Velocities are again as if the lane had not been solved.
void takeBackLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactImpulses& start) {
    BodyPair pair = load(batch, lane, bodies.velocity);
    setNormals(pair, batch, lane, {{start.normal[0], start.normal[1]}});
    setTangents(pair, batch, lane, {{start.tangent[0], start.tangent[1]}});
    if (batch.hasRollingResistance) twist(pair, batch, lane, start.roll - batch.rollImpulse[lane]);
    batch.rollImpulse[lane] = start.roll;
    store(batch, lane, pair, bodies.velocity);
}

/// The first half of a sub-step: a gap may close within h (hard), an overlap is pushed out at the soft rate, but not
/// faster than pushSpeed. bias of contact_solver.h: s/h, or biasRate s; share: massScale of softness.h.
void solveLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass) {
    BodyPair pair = load(batch, lane, bodies.velocity);
    const Points::Each now =
        pointsOf(pair, batch, lane)
            .normals(each([&](int i) { return batch.points[i].normalImpulse[lane]; }), each([&](int i) {
                         const PointLanes& p = batch.points[i];
                         const float s = p.separation[lane];
                         const float bias =
                             s > 0 ? s * pass.inverseStep : larger(pass.soft.biasRate * s, -pass.pushSpeed);
                         return normalSpeed(pair, p, lane) + bias;
                     }),
                     each([&](int i) { return batch.points[i].separation[lane] > 0 ? 1.0f : pass.soft.massScale; }));
    setNormals(pair, batch, lane, now);
    solveAlong(pair, batch, lane, {});
    store(batch, lane, pair, bodies.velocity);
}

void relaxLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass,
               const ContactImpulses& solved) {
    BodyPair pair = load(batch, lane, bodies.velocity);
    relaxPoints(pair, batch, lane, pass, solved);
    addTotals(batch, lane, solved);
    store(batch, lane, pair, bodies.velocity);
}

const ContactSolver scalarContactSolver{gatherWarmStart, solve, relax, bounce};

}  // namespace plumb
