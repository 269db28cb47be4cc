// SPDX-License-Identifier: MIT
// How are W lanes of contacts solved? One at a time with W = 1, where each value is a float; several side by side with
// vector operations. Sums are in the same order, with the same parentheses, so that the results have the same bits.
// Test: "contacts are solved to the same bits one by one and at 4, 8 and 16 lanes"
#pragma once
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/contacts/lanes/point_kinematics.h>
#include <plumb/math/detail/two_points.h>

namespace plumb {

template <int W>
struct WideContacts {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;
    using Pair = BodyPair<W>;
    using Points = TwoPoints<F>;
    using Each = typename Points::Each;

    static constexpr F all(float value) { return F{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }
    /// A number of both points.
    [[gnu::always_inline]] static inline Each each(const ContactBatch& batch, int lane,
                                                   Lanes<float> PointLanes::*field) {
        return {{at(batch.points[0].*field + lane), at(batch.points[1].*field + lane)}};
    }

    /// The impulses of the first half of the sub-step, which the second half may take back; 0 during the first half.
    struct Solved {
        Each normal{}, tangent{};
        F roll{};
    };

    /// The two bodies and the anchors of both points.
    struct Contact {
        Pair pair;
        LaneArms<W> r[2];

        [[gnu::always_inline]] inline Points points(const ContactBatch& batch, int lane) const {
            return Points::of(each(batch, lane, &PointLanes::normalMass), pair.a.w, pair.b.w,
                              {{r[0].tangentA, r[1].tangentA}}, {{r[0].tangentB, r[1].tangentB}});
        }
        [[gnu::always_inline]] inline void pushNormals(const Each& old, const Each& now) {
            for (int i = 0; i < 2; ++i) pair.pushNormal(r[i], now.at[i] - old.at[i]);
        }
        [[gnu::always_inline]] inline void pushTangents(const Each& old, const Each& now) {
            for (int i = 0; i < 2; ++i) pair.pushTangent(r[i], now.at[i] - old.at[i]);
        }
    };

    [[gnu::always_inline]] static inline Contact load(const ContactBatch& batch, int lane,
                                                      const SolverVelocity* velocity) {
        return {Pair::of(batch, lane, &velocity->x),
                {LaneArms<W>::of(batch.points[0], lane), LaneArms<W>::of(batch.points[1], lane)}};
    }

    /// Replaces the impulses of both points: the velocities change by the difference. So the sum of all passes stays
    /// limited, not each change (accumulated impulses).
    [[gnu::always_inline]] static inline void setNormals(Contact& c, ContactBatch& batch, int lane, const Each& old,
                                                         const Each& now) {
        for (int i = 0; i < 2; ++i) storeLanes(batch.points[i].normalImpulse + lane, now.at[i]);
        c.pushNormals(old, now);
    }
    [[gnu::always_inline]] static inline void setTangents(Contact& c, ContactBatch& batch, int lane, const Each& old,
                                                          const Each& now) {
        for (int i = 0; i < 2; ++i) storeLanes(batch.points[i].tangentImpulse + lane, now.at[i]);
        c.pushTangents(old, now);
    }

    /// A torque against rolling on each other, limited to rollingArm times the normal impulse of both halves: the
    /// resistance of a wheel that is pressed flat. Test: "a disc with rolling resistance 0.2 slows down at 2/3 0.2 g =
    /// 1.308 m/s^2 and stands after 1.53 s"
    static void solveRolling(Pair& c, ContactBatch& batch, int lane, const Each& normal, const Solved& solved) {
        const F old = at(batch.rollImpulse + lane);
        const F limit =
            at(batch.rollingArm + lane) * ((solved.normal.at[0] + normal.at[0]) + (solved.normal.at[1] + normal.at[1]));
        const F speed = at(batch.rollInverseGyrationB + lane) * c.b.z - at(batch.rollInverseGyrationA + lane) * c.a.z;
        const F wanted = old - at(batch.rollMass + lane) * speed;
        const F now = larger(smaller(wanted, limit - solved.roll), -limit - solved.roll);
        storeLanes(batch.rollImpulse + lane, now);
        c.twist(batch, lane, now - old);
    }

    /// After the normal impulses, so that the limit is known even in a contact's first sub-step: friction of both
    /// halves together is limited to mu times the normal impulse of both (Coulomb's cone). Returns the tangent
    /// impulses.
    [[gnu::always_inline]] static inline Each solveAlong(Contact& c, ContactBatch& batch, int lane, const Each& normal,
                                                         const Solved& solved) {
        const F friction = at(batch.friction + lane);
        const F belt = batch.hasSurfaceSpeed ? at(batch.surfaceSpeed + lane) : F{};
        const Each old = each(batch, lane, &PointLanes::tangentImpulse);
        const Each now = Points::tangents(
            each(batch, lane, &PointLanes::tangentMass), old, solved.tangent,
            {{c.pair.tangentSpeed(c.r[0]) + belt, c.pair.tangentSpeed(c.r[1]) + belt}},
            {{friction * (solved.normal.at[0] + normal.at[0]), friction * (solved.normal.at[1] + normal.at[1])}});
        setTangents(c, batch, lane, old, now);
        if (batch.hasRollingResistance) solveRolling(c.pair, batch, lane, normal, solved);
        return now;
    }

    /// Once a step, before the first sub-step. Bodies gather the velocity changes by the impulses of all their
    /// contacts, and kickBodies applies them in each half: so the contacts are not passed again for that.
    static void gatherLanes(const ContactBatch& batch, int lane, const SolverBodies& bodies) {
        Contact c = load(batch, lane, bodies.warm);
        c.pair.a.w = loadRows<W>(&bodies.velocity->x, batch.bodyA + lane).w;
        c.pair.b.w = loadRows<W>(&bodies.velocity->x, batch.bodyB + lane).w;
        for (int i = 0; i < 2; ++i) {
            c.pair.pushNormal(c.r[i], at(batch.points[i].normalImpulse + lane));
            c.pair.pushTangent(c.r[i], at(batch.points[i].tangentImpulse + lane));
        }
        if (batch.hasRollingResistance) c.pair.twist(batch, lane, at(batch.rollImpulse + lane));
        // warm is added to velocity as a whole, which must keep its inverse mass.
        c.pair.a.w = c.pair.b.w = F{};
        c.pair.store(batch, lane, &bodies.warm->x);
    }

    /// The first half of a sub-step: a gap may close within h (hard), an overlap is pushed out at the soft rate, but
    /// not faster than pushSpeed. bias: s/h, or biasRate s; share: massScale of softness.h. At pushSpeed the contact is
    /// hard, too: a spring whose push is limited would sink in for ever under a load.
    /// Test: "a box pressed by 100 to 100,000 times its weight rests"
    static void solveLanes(ContactBatch& batch, int lane, const SolverBodies& bodies, const ContactPass& pass) {
        Contact c = load(batch, lane, bodies.velocity);
        const Each old = each(batch, lane, &PointLanes::normalImpulse);
        Each speed, share;
        for (int i = 0; i < 2; ++i) {
            const F s = at(batch.points[i].separation + lane);
            // Both cases are computed and one is chosen, lane by lane: vectors have no branches.
            const auto apart = s > F{};
            const F push = pass.soft.biasRate * s,
                    bias = apart ? s * pass.inverseStep : larger(push, all(-pass.pushSpeed));
            share.at[i] = either<M>(apart, push < all(-pass.pushSpeed)) ? all(1) : all(pass.soft.massScale);
            speed.at[i] = c.pair.normalSpeed(c.r[i]) + bias;
        }
        const Each normal = c.points(batch, lane).normals(old, speed, share);
        setNormals(c, batch, lane, old, normal);
        solveAlong(c, batch, lane, normal, Solved{});
        c.pair.store(batch, lane, &bodies.velocity->x);
    }

    /// The second half of a sub-step. kickBodies has applied the impulses of the first half once more, as a guess; here
    /// the sum of both halves is limited to a push, so the second half may take back what the first half gave to
    /// correct positions. Where a gap s is left, the points may close it within h, and no faster. old: of this half, so
    /// far. The impulses of both halves, added to the totals, count for events, friction loads and bounces. pushed
    /// tells storeBodies that the two bodies do not fly freely.
    [[gnu::always_inline]] static inline void relaxPoints(Contact& c, ContactBatch& batch, int lane,
                                                          const ContactPass& pass, const Solved& solved,
                                                          const Each& old, const Each& s) {
        Each speed, normal;
        for (int i = 0; i < 2; ++i) {
            speed.at[i] = c.pair.normalSpeed(c.r[i]) + larger(s.at[i], F{}) * pass.inverseStep;
            normal.at[i] = solved.normal.at[i] + old.at[i];
        }
        normal = c.points(batch, lane).normals(normal, speed, {{all(1), all(1)}});
        for (int i = 0; i < 2; ++i) normal.at[i] = normal.at[i] - solved.normal.at[i];
        setNormals(c, batch, lane, old, normal);
        const Each tangent = solveAlong(c, batch, lane, normal, solved);
        I pushed = loadLanes<W>(batch.pushed + lane);
        for (int i = 0; i < 2; ++i) {
            PointLanes& p = batch.points[i];
            storeLanes(p.totalNormal + lane, at(p.totalNormal + lane) + (solved.normal.at[i] + normal.at[i]));
            storeLanes(p.totalTangent + lane, at(p.totalTangent + lane) + (solved.tangent.at[i] + tangent.at[i]));
            pushed = either<M>(solved.normal.at[i] > F{}, normal.at[i] > F{}) ? I{} - 1 : pushed;
        }
        storeLanes(batch.pushed + lane, pushed);
    }

    [[gnu::always_inline]] static inline Solved impulses(const ContactBatch& batch, int lane) {
        return {each(batch, lane, &PointLanes::normalImpulse), each(batch, lane, &PointLanes::tangentImpulse),
                batch.hasRollingResistance ? at(batch.rollImpulse + lane) : F{}};
    }
    [[gnu::always_inline]] static inline void relaxLanes(ContactBatch& batch, int lane, const SolverBodies& bodies,
                                                         const ContactPass& pass) {
        Contact c = load(batch, lane, bodies.velocity);
        const Pair moved = Pair::of(batch, lane, &bodies.displacement->x);
        const Solved solved = impulses(batch, lane);
        Each s;
        for (int i = 0; i < 2; ++i) {
            s.at[i] = moved.separation(batch, batch.points[i], lane, c.r[i]);
            storeLanes(batch.points[i].separation + lane, s.at[i]);
        }
        relaxPoints(c, batch, lane, pass, solved, solved.normal, s);
        c.pair.store(batch, lane, &bodies.velocity->x);
    }

    /// Once, at the step's end: the points part at e times their approach at the step's start, but only where they have
    /// pushed, so that what was only near does not bounce. As before, it is the sum of a point's impulses that may not
    /// pull. A point that does not bounce takes no part: its impulse stays what it was.
    static void bounceLanes(ContactBatch& batch, int lane, const SolverBodies& bodies) {
        Contact c = load(batch, lane, bodies.velocity);
        const Each old = each(batch, lane, &PointLanes::totalNormal),
                   target = each(batch, lane, &PointLanes::bounceSpeed);
        Points points = c.points(batch, lane);
        const M first = both<M>(target.at[0] > F{}, old.at[0] > F{}),
                second = both<M>(target.at[1] > F{}, old.at[1] > F{}), together = both<M>(first, second);
        points.coupling = together ? points.coupling : F{};
        points.freedom = together ? points.freedom : all(1);
        Each now = points.normals(
            old, {{c.pair.normalSpeed(c.r[0]) - target.at[0], c.pair.normalSpeed(c.r[1]) - target.at[1]}},
            {{all(1), all(1)}});
        now = {{first ? now.at[0] : old.at[0], second ? now.at[1] : old.at[1]}};
        for (int i = 0; i < 2; ++i) storeLanes(batch.points[i].totalNormal + lane, now.at[i]);
        c.pushNormals(old, now);
        c.pair.store(batch, lane, &bodies.velocity->x);
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
