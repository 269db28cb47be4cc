// SPDX-License-Identifier: MIT
// How are W lanes of contacts solved with vector operations? The formulas are those of the scalar solver
// (contact_solver.cpp); each float there is a vector of W floats here.
#pragma once
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct WideContacts {
    using F = typename Wide<W>::Float;
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

    [[gnu::always_inline]] static inline BodyPair load(const ContactBatch& batch, int lane,
                                                       const SolverVelocity* velocity) {
        return {loadRows<W>(rows(velocity), batch.bodyA + lane), loadRows<W>(rows(velocity), batch.bodyB + lane),
                at(batch.normalX + lane), at(batch.normalY + lane)};
    }
    [[gnu::always_inline]] static inline void store(const ContactBatch& batch, int lane, const BodyPair& c,
                                                    SolverVelocity* velocity) {
        storeRows<W>(rows(velocity), batch.bodyA + lane, c.a);
        storeRows<W>(rows(velocity), batch.bodyB + lane, c.b);
    }

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

    /// The impulses of the first half of the sub-step, which the second half may take back; 0 during the first half.
    struct Given {
        F normal[2], tangent[2], roll;
    };

    static F clamped(F wanted, F limit, F before) { return larger(smaller(wanted, limit - before), -limit - before); }

    [[gnu::always_inline]] static inline void solveAlong(BodyPair& c, ContactBatch& batch, int lane, const Arms* arms,
                                                         const F* normal, const Given& given, F* tangent) {
        const F friction = at(batch.friction + lane);
        const F belt = batch.hasSurfaceSpeed ? at(batch.surfaceSpeed + lane) : F{};
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            const F old = at(p.tangentImpulse + lane);
            const F limit = friction * (given.normal[i] + normal[i]);
            const F wanted = old - at(p.tangentMass + lane) * (tangentSpeed(c, arms[i]) + belt);
            tangent[i] = clamped(wanted, limit, given.tangent[i]);
            storeLanes(p.tangentImpulse + lane, tangent[i]);
            pushTangent(c, arms[i], tangent[i] - old);
        }
        if (!batch.hasRollingResistance) return;
        const F old = at(batch.rollImpulse + lane);
        const F limit = at(batch.rollingArm + lane) * ((given.normal[0] + normal[0]) + (given.normal[1] + normal[1]));
        const F speed = at(batch.rollInverseGyrationB + lane) * c.b.z - at(batch.rollInverseGyrationA + lane) * c.a.z;
        const F now = clamped(old - at(batch.rollMass + lane) * speed, limit, given.roll);
        storeLanes(batch.rollImpulse + lane, now);
        twist(c, batch, lane, now - old);
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
        F normal[2], tangent[2];
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            const F s = at(p.separation + lane);
            const auto apart = s > F{};
            const F bias = apart ? s * pass.inverseStep : larger(pass.soft.biasRate * s, all(-pass.pushSpeed));
            const F massScale = apart ? all(1) : all(pass.soft.massScale);
            const F impulseScale = apart ? F{} : all(pass.soft.impulseScale);
            const F old = at(p.normalImpulse + lane);
            const F change =
                -(at(p.normalMass + lane) * massScale) * (normalSpeed(c, r[i]) + bias) - impulseScale * old;
            normal[i] = larger(old + change, F{});
            storeLanes(p.normalImpulse + lane, normal[i]);
            pushNormal(c, r[i], normal[i] - old);
        }
        solveAlong(c, batch, lane, r, normal, Given{}, tangent);
        store(batch, lane, c, bodies.velocity);
    }

    [[gnu::always_inline]] static inline void relaxLanes(ContactBatch& batch, int lane, const SolverBodies& bodies,
                                                         const ContactPass& pass) {
        BodyPair c = load(batch, lane, bodies.velocity);
        const Bodies da = loadRows<W>(&bodies.displacement->x, batch.bodyA + lane);
        const Bodies db = loadRows<W>(&bodies.displacement->x, batch.bodyB + lane);
        const Arms r[2] = {arms(batch.points[0], lane), arms(batch.points[1], lane)};
        F normal[2], tangent[2];
        Given given;
        given.roll = batch.hasRollingResistance ? at(batch.rollImpulse + lane) : F{};
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            given.normal[i] = at(p.normalImpulse + lane);
            given.tangent[i] = at(p.tangentImpulse + lane);
            const F s = separationNow(batch, p, r[i], lane, c, da, db);
            storeLanes(p.separation + lane, s);
            const F speed = normalSpeed(c, r[i]) + larger(s, F{}) * pass.inverseStep;
            normal[i] = larger(given.normal[i] - at(p.normalMass + lane) * speed, -given.normal[i]);
            storeLanes(p.normalImpulse + lane, normal[i]);
            pushNormal(c, r[i], normal[i] - given.normal[i]);
        }
        solveAlong(c, batch, lane, r, normal, given, tangent);
        auto pushed = loadLanes<W>(batch.pushed + lane);
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            storeLanes(p.totalNormal + lane, at(p.totalNormal + lane) + (given.normal[i] + normal[i]));
            storeLanes(p.totalTangent + lane, at(p.totalTangent + lane) + (given.tangent[i] + tangent[i]));
            pushed |= (given.normal[i] > F{}) | (normal[i] > F{});
        }
        storeLanes(batch.pushed + lane, pushed);
        store(batch, lane, c, bodies.velocity);
    }

    static void bounceLanes(ContactBatch& batch, int lane, const SolverBodies& bodies) {
        BodyPair c = load(batch, lane, bodies.velocity);
        for (PointLanes& p : batch.points) {
            const Arms r = arms(p, lane);
            const F old = at(p.totalNormal + lane);
            const F target = at(p.bounceSpeed + lane);
            const auto bounces = (target > F{}) & (old > F{});
            const F change = -at(p.normalMass + lane) * (normalSpeed(c, r) - target);
            const F now = bounces ? larger(old + change, F{}) : old;
            storeLanes(p.totalNormal + lane, now);
            pushNormal(c, r, now - old);
        }
        store(batch, lane, c, bodies.velocity);
    }

    /// Calls visit(batch, lane) for each W lanes of which some are in use.
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
