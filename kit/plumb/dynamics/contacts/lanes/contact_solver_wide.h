// SPDX-License-Identifier: MIT
// How are W lanes of contacts solved with vector operations? The formulas are those of the scalar solver
// (contact_solver.cpp), which explains them; each float there is a vector of W floats here. Sums are in the same order,
// with the same parentheses, so that the results have the same bits.
// Test: "contacts are solved to the same bits one by one and at 4, 8 and 16 lanes"
#pragma once
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/contacts/lanes/two_points.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct WideContacts {
    using F = typename Wide<W>::Float;
    /// Of velocities, z is w = omega / rho, and w is the inverse mass; of displacements, z and w are sin and cosMinus1.
    using Bodies = Rows<W>;

    static constexpr F all(float value) { return F{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }
    static const float* rows(const SolverVelocity* v) { return &v->x; }
    static float* rows(SolverVelocity* v) { return &v->x; }

    /// The two bodies of W lanes, and the contacts' normals.
    struct BodyPair {
        Bodies a, b;
        F nx, ny;
    };

    // Always inlined: arguments of a call are passed through memory where vectors are wide, and each lane has many.
    [[gnu::always_inline]] static inline BodyPair load(const ContactBatch& batch, int lane,
                                                       const SolverVelocity* velocity) {
        return {loadRows<W>(rows(velocity), batch.bodyA + lane), loadRows<W>(rows(velocity), batch.bodyB + lane),
                at(batch.normalX + lane), at(batch.normalY + lane)};
    }
    // Lanes of a batch share no body that moves, so that no store undoes another one. A wall may be in several: all of
    // them store the row that they have loaded.
    [[gnu::always_inline]] static inline void store(const ContactBatch& batch, int lane, const BodyPair& c,
                                                    SolverVelocity* velocity) {
        storeRows<W>(rows(velocity), batch.bodyA + lane, c.a);
        storeRows<W>(rows(velocity), batch.bodyB + lane, c.b);
    }

    using Points = TwoPoints<F>;
    using Each = typename Points::Each;

    /// The anchors of a point.
    struct Arms {
        F normalA, tangentA, normalB, tangentB;
    };
    [[gnu::always_inline]] static inline Arms arms(const PointLanes& p, int lane) {
        return {at(p.anchorNormalA + lane), at(p.anchorTangentA + lane), at(p.anchorNormalB + lane),
                at(p.anchorTangentB + lane)};
    }

    [[gnu::always_inline]] static inline F normalSpeed(const BodyPair& c, const Arms& r) {
        return (c.nx * (c.b.x - c.a.x) + c.ny * (c.b.y - c.a.y)) + (r.tangentA * c.a.z - r.tangentB * c.b.z);
    }
    [[gnu::always_inline]] static inline F tangentSpeed(const BodyPair& c, const Arms& r) {
        return (c.nx * (c.b.y - c.a.y) - c.ny * (c.b.x - c.a.x)) + (r.normalB * c.b.z - r.normalA * c.a.z);
    }
    [[gnu::always_inline]] static inline void pushNormal(BodyPair& c, const Arms& r, F impulse) {
        const F ja = c.a.w * impulse;
        const F jb = c.b.w * impulse;
        c.a.x -= ja * c.nx;
        c.a.y -= ja * c.ny;
        c.a.z += ja * r.tangentA;
        c.b.x += jb * c.nx;
        c.b.y += jb * c.ny;
        c.b.z -= jb * r.tangentB;
    }
    [[gnu::always_inline]] static inline void pushTangent(BodyPair& c, const Arms& r, F impulse) {
        const F ja = c.a.w * impulse;
        const F jb = c.b.w * impulse;
        c.a.x += ja * c.ny;
        c.a.y -= ja * c.nx;
        c.a.z -= ja * r.normalA;
        c.b.x -= jb * c.ny;
        c.b.y += jb * c.nx;
        c.b.z += jb * r.normalB;
    }
    static void twist(BodyPair& c, const ContactBatch& batch, int lane, F impulse) {
        c.a.z -= c.a.w * (at(batch.rollInverseGyrationA + lane) * impulse);
        c.b.z += c.b.w * (at(batch.rollInverseGyrationB + lane) * impulse);
    }

    [[gnu::always_inline]] static inline F separationNow(const ContactBatch& batch, const PointLanes& p, const Arms& r,
                                                         int lane, const BodyPair& c, const Bodies& a,
                                                         const Bodies& b) {
        const F shift = c.nx * (b.x - a.x) + c.ny * (b.y - a.y);
        const F innerA = r.normalA - at(batch.roundA + lane);
        const F innerB = r.normalB + at(batch.roundB + lane);
        const F turnA = innerA * a.w - r.tangentA * a.z;
        const F turnB = innerB * b.w - r.tangentB * b.z;
        return at(p.startSeparation + lane) + (shift + (turnB - turnA));
    }

    /// A number of both points.
    [[gnu::always_inline]] static inline Each each(const ContactBatch& batch, int lane,
                                                   Lanes<float> PointLanes::*field) {
        return {{at(batch.points[0].*field + lane), at(batch.points[1].*field + lane)}};
    }
    [[gnu::always_inline]] static inline Points pointsOf(const ContactBatch& batch, int lane, const BodyPair& c,
                                                         const Arms* r) {
        return Points::of(each(batch, lane, &PointLanes::normalMass), c.a.w, c.b.w, {{r[0].tangentA, r[1].tangentA}},
                          {{r[0].tangentB, r[1].tangentB}});
    }
    [[gnu::always_inline]] static inline void setNormals(BodyPair& c, ContactBatch& batch, int lane, const Arms* r,
                                                         const Each& old, const Each& now) {
        for (int i = 0; i < 2; ++i) {
            storeLanes(batch.points[i].normalImpulse + lane, now.at[i]);
            pushNormal(c, r[i], now.at[i] - old.at[i]);
        }
    }

    /// The impulses of the first half of the sub-step, which the second half may take back; 0 during the first half.
    struct Solved {
        Each normal{}, tangent{};
        F roll{};
    };

    /// The impulse of this half of the sub-step, so that it and the one before are together within the limit.
    static F clamped(F wanted, F limit, F before) { return larger(smaller(wanted, limit - before), -limit - before); }

    static void solveRolling(BodyPair& c, ContactBatch& batch, int lane, const Each& normal, const Solved& solved) {
        const F old = at(batch.rollImpulse + lane);
        const F limit =
            at(batch.rollingArm + lane) * ((solved.normal.at[0] + normal.at[0]) + (solved.normal.at[1] + normal.at[1]));
        const F speed = at(batch.rollInverseGyrationB + lane) * c.b.z - at(batch.rollInverseGyrationA + lane) * c.a.z;
        const F now = clamped(old - at(batch.rollMass + lane) * speed, limit, solved.roll);
        storeLanes(batch.rollImpulse + lane, now);
        twist(c, batch, lane, now - old);
    }

    /// Returns the tangent impulses.
    [[gnu::always_inline]] static inline Each solveAlong(BodyPair& c, ContactBatch& batch, int lane, const Arms* r,
                                                         const Each& normal, const Solved& solved) {
        const F friction = at(batch.friction + lane);
        const F belt = batch.hasSurfaceSpeed ? at(batch.surfaceSpeed + lane) : F{};
        const Each old = each(batch, lane, &PointLanes::tangentImpulse);
        const Each now = Points::tangents(
            each(batch, lane, &PointLanes::tangentMass), old, solved.tangent,
            {{tangentSpeed(c, r[0]) + belt, tangentSpeed(c, r[1]) + belt}},
            {{friction * (solved.normal.at[0] + normal.at[0]), friction * (solved.normal.at[1] + normal.at[1])}});
        for (int i = 0; i < 2; ++i) {
            storeLanes(batch.points[i].tangentImpulse + lane, now.at[i]);
            pushTangent(c, r[i], now.at[i] - old.at[i]);
        }
        if (batch.hasRollingResistance) solveRolling(c, batch, lane, normal, solved);
        return now;
    }

    static void gatherLanes(const ContactBatch& batch, int lane, const SolverBodies& bodies) {
        BodyPair c = load(batch, lane, bodies.warm);
        c.a.w = loadRows<W>(rows(bodies.velocity), batch.bodyA + lane).w;
        c.b.w = loadRows<W>(rows(bodies.velocity), batch.bodyB + lane).w;
        for (const PointLanes& p : batch.points) {
            const Arms r = arms(p, lane);
            pushNormal(c, r, at(p.normalImpulse + lane));
            pushTangent(c, r, at(p.tangentImpulse + lane));
        }
        if (batch.hasRollingResistance) twist(c, batch, lane, at(batch.rollImpulse + lane));
        c.a.w = c.b.w = F{};
        store(batch, lane, c, bodies.warm);
    }

    [[gnu::always_inline]] static inline void solveLanes(ContactBatch& batch, int lane, const SolverBodies& bodies,
                                                         const ContactPass& pass) {
        BodyPair c = load(batch, lane, bodies.velocity);
        const Arms r[2] = {arms(batch.points[0], lane), arms(batch.points[1], lane)};
        const Each old = each(batch, lane, &PointLanes::normalImpulse);
        Each speed, share;
        for (int i = 0; i < 2; ++i) {
            const F s = at(batch.points[i].separation + lane);
            // Both cases are computed and one is chosen, lane by lane: vectors have no branches.
            const auto apart = s > F{};
            const F bias = apart ? s * pass.inverseStep : larger(pass.soft.biasRate * s, all(-pass.pushSpeed));
            share.at[i] = apart ? all(1) : all(pass.soft.massScale);
            speed.at[i] = normalSpeed(c, r[i]) + bias;
        }
        const Each normal = pointsOf(batch, lane, c, r).normals(old, speed, share);
        setNormals(c, batch, lane, r, old, normal);
        solveAlong(c, batch, lane, r, normal, Solved{});
        store(batch, lane, c, bodies.velocity);
    }

    [[gnu::always_inline]] static inline void relaxLanes(ContactBatch& batch, int lane, const SolverBodies& bodies,
                                                         const ContactPass& pass) {
        BodyPair c = load(batch, lane, bodies.velocity);
        const Bodies da = loadRows<W>(&bodies.displacement->x, batch.bodyA + lane);
        const Bodies db = loadRows<W>(&bodies.displacement->x, batch.bodyB + lane);
        const Arms r[2] = {arms(batch.points[0], lane), arms(batch.points[1], lane)};
        const Solved solved{each(batch, lane, &PointLanes::normalImpulse),
                            each(batch, lane, &PointLanes::tangentImpulse),
                            batch.hasRollingResistance ? at(batch.rollImpulse + lane) : F{}};
        Each speed, normal;
        for (int i = 0; i < 2; ++i) {
            const F s = separationNow(batch, batch.points[i], r[i], lane, c, da, db);
            storeLanes(batch.points[i].separation + lane, s);
            speed.at[i] = normalSpeed(c, r[i]) + larger(s, F{}) * pass.inverseStep;
            // The sum of both halves, the second one as guessed: kickBodies has applied the first one's impulse again.
            normal.at[i] = solved.normal.at[i] + solved.normal.at[i];
        }
        normal = pointsOf(batch, lane, c, r).normals(normal, speed, {{all(1), all(1)}});
        for (int i = 0; i < 2; ++i) normal.at[i] = normal.at[i] - solved.normal.at[i];
        setNormals(c, batch, lane, r, solved.normal, normal);
        const Each tangent = solveAlong(c, batch, lane, r, normal, solved);
        auto pushed = loadLanes<W>(batch.pushed + lane);
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            storeLanes(p.totalNormal + lane, at(p.totalNormal + lane) + (solved.normal.at[i] + normal.at[i]));
            storeLanes(p.totalTangent + lane, at(p.totalTangent + lane) + (solved.tangent.at[i] + tangent.at[i]));
            // A comparison is a mask of all ones: -1, as in the scalar solver.
            pushed |= (solved.normal.at[i] > F{}) | (normal.at[i] > F{});
        }
        storeLanes(batch.pushed + lane, pushed);
        store(batch, lane, c, bodies.velocity);
    }

    static void bounceLanes(ContactBatch& batch, int lane, const SolverBodies& bodies) {
        BodyPair c = load(batch, lane, bodies.velocity);
        const Arms r[2] = {arms(batch.points[0], lane), arms(batch.points[1], lane)};
        const Each old = each(batch, lane, &PointLanes::totalNormal),
                   target = each(batch, lane, &PointLanes::bounceSpeed);
        Points points = pointsOf(batch, lane, c, r);
        const auto first = (target.at[0] > F{}) & (old.at[0] > F{}), second = (target.at[1] > F{}) & (old.at[1] > F{});
        points.coupling = first & second ? points.coupling : F{};
        points.freedom = first & second ? points.freedom : all(1);
        Each now = points.normals(old, {{normalSpeed(c, r[0]) - target.at[0], normalSpeed(c, r[1]) - target.at[1]}},
                                  {{all(1), all(1)}});
        now = {{first ? now.at[0] : old.at[0], second ? now.at[1] : old.at[1]}};
        for (int i = 0; i < 2; ++i) {
            storeLanes(batch.points[i].totalNormal + lane, now.at[i]);
            pushNormal(c, r[i], now.at[i] - old.at[i]);
        }
        store(batch, lane, c, bodies.velocity);
    }

    /// Calls visit(batch, lane) for each W lanes of which some are in use. The others are empty: bodies 0 and masses 0,
    /// so that nothing comes of them.
    template <class Batch, class Visit>
    [[gnu::always_inline]] static inline void forEach(Batch* batches, std::size_t contacts, Visit&& visit) {
        for (std::size_t i = 0; i < contacts; i += static_cast<std::size_t>(W))
            visit(batches[i / batchLanes], static_cast<int>(i % batchLanes));
    }
    static void gatherWarmStart(const ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies) {
        forEach(batches, contacts, [&](const ContactBatch& batch, int lane) { gatherLanes(batch, lane, bodies); });
    }
    static void solve(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies,
                      const ContactPass& pass) {
        forEach(batches, contacts, [&](ContactBatch& batch, int lane) { solveLanes(batch, lane, bodies, pass); });
    }
    static void relax(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies,
                      const ContactPass& pass) {
        forEach(batches, contacts, [&](ContactBatch& batch, int lane) { relaxLanes(batch, lane, bodies, pass); });
    }
    static void bounce(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies) {
        forEach(batches, contacts, [&](ContactBatch& batch, int lane) {
            if (batch.bounces) bounceLanes(batch, lane, bodies);
        });
    }
};

template <int W>
const ContactSolver WideContactSolver<W>::code{WideContacts<W>::gatherWarmStart, WideContacts<W>::solve,
                                               WideContacts<W>::relax, WideContacts<W>::bounce};

}  // namespace plumb
