// SPDX-License-Identifier: MIT
// What does the solver need from new manifolds, for W lanes at a time? Impulses move with their points into the new
// manifold; anchors, effective masses and separations are computed for the step.
#pragma once
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/collide/lanes/relative_lanes.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/lanes/resting_arms.h>
#include <plumb/impact/detail/bounces.h>

namespace plumb {

template <int W>
struct LanePreparer {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;

    /// A point that overlaps by less than this counts as just touching: an impact there is solved as a hard contact,
    /// like one with a gap, and not as a soft one, which does not stop it in one sub-step [m]. It is above the rounding
    /// of separations, and below what bodies at rest sink in.
    static constexpr float justTouching = 1e-5f;
    /// A point that overlaps by more than this and parts does not count as an impact [m].
    static constexpr float deep = 1e-4f;

    static F all(float value) { return F{} + value; }
    static I whole(int value) { return I{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }

    /// Which points of the new manifold continue which points of the old one, as far as found. An old point has one
    /// successor at most: two would start with twice the impulse.
    struct Matches {
        M same[2][2];    ///< [p][q]: point p is the successor of the old point q
        M single[2];     ///< p has no predecessor
        M unclaimed[2];  ///< q has no successor

        void claim(int p, int q, M wanted) {
            const M free = single[p] ? unclaimed[q] : M{};
            const M gets = free ? wanted : M{};
            same[p][q] = gets ? gets : same[p][q];
            unclaimed[q] = gets ? M{} : unclaimed[q];
            single[p] = gets ? M{} : single[p];
        }
    };

    /// Do both the new point p and the old point q exist?
    static M bothThere(I count, I wasCount, int p, int q) {
        const M there = count > whole(p);
        const M was = wasCount > whole(q);
        return there ? was : M{};
    }

    static M nearEachOther(const FreshPoint& p, const ManifoldPointLanes& q, int lane) {
        const F x = at(p.x + lane) - at(q.x + lane);
        const F y = at(p.y + lane) - at(q.y + lane);
        return x * x + y * y < all(contactMargin * contactMargin);
    }

    /// First matches points with equal features. Then matches the remaining points that are near each other: if a box
    /// lies almost flush on an equal box, the clipping corner belongs now to the one and now to the other, and the
    /// features change with it.
    static Matches matches(const FreshLanes& fresh, const ManifoldLanes& was, int lane) {
        const I count = loadLanes<W>(fresh.count + lane), wasCount = loadLanes<W>(was.count + lane);
        const M yes = count == count;
        Matches found{{{M{}, M{}}, {M{}, M{}}}, {yes, yes}, {yes, yes}};
        for (int p = 0; p < 2; ++p) {
            const I feature = loadLanes<W>(fresh.points[p].feature + lane);
            for (int q = 0; q < 2; ++q) {
                const M same = feature == loadLanes<W>(was.points[q].feature + lane);
                const M both = bothThere(count, wasCount, p, q);
                found.claim(p, q, both ? same : M{});
            }
        }
        for (int p = 0; p < 2; ++p) {
            for (int q = 0; q < 2; ++q) {
                const M near = nearEachOther(fresh.points[p], was.points[q], lane);
                const M both = bothThere(count, wasCount, p, q);
                found.claim(p, q, both ? near : M{});
            }
        }
        return found;
    }

    /// The impulse of half a sub-step with which a point starts [N s]: that of the last half sub-step, if steps are
    /// equally long. If this step is not as long as the last one, the mean force of that one counts, and of a shorter
    /// one only its share of this step; for the rest, the force before it: in a short step, a small change of speed is
    /// a large force. Test: "towers stand for a minute while the step's length changes"
    static F carried(float* force, const float* impulse, const float* total, int lane, const StepLength& step) {
        if (step.ratio == 1) return at(impulse + lane);
        const float share = step.ratio > 1 ? 1 / step.ratio : 1.0f;
        const F now = at(total + lane) * (share * step.ratio * step.inverse) + at(force + lane) * (1 - share);
        storeLanes(force + lane, now);
        return now * (1 / (step.inverse * static_cast<float>(step.halves)));
    }

    /// All old impulses are read before any is written: the two points may have changed places.
    static void carry(ContactBatch& batch, ManifoldLanes& m, int lane, const Matches& found, const StepLength& step) {
        F normal[2], tangent[2];
        for (int q = 0; q < 2; ++q) {
            const PointLanes& was = batch.points[q];
            ManifoldPointLanes& force = m.points[q];
            normal[q] = carried(force.normalForce, was.normalImpulse, was.totalNormal, lane, step);
            tangent[q] = carried(force.tangentForce, was.tangentImpulse, was.totalTangent, lane, step);
        }
        for (int p = 0; p < 2; ++p) {
            const M one = found.same[p][0], two = found.same[p][1];
            const F secondNormal = two ? normal[1] : F{}, secondTangent = two ? tangent[1] : F{};
            storeLanes(batch.points[p].normalImpulse + lane, one ? normal[0] : secondNormal);
            storeLanes(batch.points[p].tangentImpulse + lane, one ? tangent[0] : secondTangent);
        }
        storeLanes(batch.rollImpulse + lane, at(batch.rollImpulse + lane) * step.ratio);
    }

    /// The two bodies and the contact's normal, for the formulas.
    struct Sides {
        BodyPair<W> velocity;
        Rows<W> pullA, pullB;  ///< velocity changes by acceleration in half a step [m/s]
        F inverseGyrationA, inverseGyrationB;
        F resting;  ///< a slower approach is no impact: the speed gained by acceleration in half a step [m/s]
        F press;    ///< approach speed gained by both accelerations in a step [m/s]

        /// resting and press depend on the normal, and so on whether it stays the one of the last step.
        void setNormal(F x, F y) {
            velocity.nx = x;
            velocity.ny = y;
            const F alongA = pullA.x * x + pullA.y * y, alongB = pullB.x * x + pullB.y * y;
            resting = larger(magnitude(alongA), magnitude(alongB));
            press = 2 * (alongA - alongB);
        }
        LaneArms<W> arms(F rax, F ray, F rbx, F rby) const {
            const F nx = velocity.nx, ny = velocity.ny;
            return {inverseGyrationA * (nx * rax + ny * ray), inverseGyrationA * (nx * ray - ny * rax),
                    inverseGyrationB * (nx * rbx + ny * rby), inverseGyrationB * (nx * rby - ny * rbx)};
        }
    };

    static Sides sides(const ContactBatch& batch, int lane, const BodyPlace* places, const SolverVelocity* velocity) {
        Sides s;
        // A BodyPlace has sixteen floats in four rows: the second has inverseGyration as its z, the fourth the pull.
        const float* rows = &places->highX;
        s.velocity = BodyPair<W>::of(batch, lane, &velocity->x);
        s.inverseGyrationA = loadRows<W, 16>(rows + 4, batch.bodyA + lane).z;
        s.inverseGyrationB = loadRows<W, 16>(rows + 4, batch.bodyB + lane).z;
        s.pullA = loadRows<W, 16>(rows + 12, batch.bodyA + lane);
        s.pullB = loadRows<W, 16>(rows + 12, batch.bodyB + lane);
        return s;
    }

    /// Would the bounces of this point, if it were alone, last longer than the step? Then the impact is solved by its
    /// closed form (impacts/). Points that overlap and part are left to the solver.
    /// v^2 = u^2 + 2 a s: impact speed. Bounces last 2 v/a (e + e^2 + ...), see bounces.h, so the test is 4 sum^2 v^2
    /// >= (a dt)^2.
    /// u opening [m/s], s separation [m], a dt press, e restitution [-]; fall = a s
    static M isClear(const Sides& s, F opening, F separation, F restitution, float inverseStep) {
        const F fall = larger(s.press * separation * inverseStep, F{});
        const F squared = opening * opening + 2 * fall;
        const F sum = sumOfBounces(restitution);
        const M high = 4 * sum * sum * squared >= s.press * larger(s.press, F{});
        const M parts = opening >= F{};
        const M overlaps = separation < all(-deep);
        const M pushed = overlaps ? parts : M{};
        return pushed ? M{} : high;
    }

    /// Fills the lanes of a point, but for its arms; returns the speed at which it opens [m/s].
    static F preparePoint(PointLanes& p, int lane, const Sides& s, const LaneArms<W>& arms, F separation, F restitution,
                          M present) {
        const F ma = s.velocity.a.w, mb = s.velocity.b.w, opening = s.velocity.normalSpeed(arms);
        const F parting = restitution * -opening;
        const M fast = -opening > s.resting, near = separation > all(-justTouching);
        const M hits = fast ? near : M{};
        // Just above 0, where the solver takes a point as a gap: hard, and closed within h.
        const F start = hits ? larger(separation, all(1e-9f)) : separation;
        // What parts more slowly than its acceleration in half a step is no bounce: else what rests would never lie
        // still.
        const F target = bounces(restitution, -opening, s.resting) ? parting : F{};
        storeLanes(p.normalMass + lane, present ? 1.0f / arms.normalInverse(ma, mb) : F{});
        storeLanes(p.tangentMass + lane, present ? 1.0f / arms.tangentInverse(ma, mb) : F{});
        storeLanes(p.startSeparation + lane, present ? start : F{});
        storeLanes(p.separation + lane, present ? start : F{});
        storeLanes(p.totalNormal + lane, F{});
        storeLanes(p.totalTangent + lane, F{});
        storeLanes(p.bounceSpeed + lane, present ? target : F{});
        return opening;
    }

    /// The normal and the arms of this step, which stay those of the last one where a face rests on a face. The
    /// manifold keeps the true normal, for events, and for steps in which it is used again.
    static void placeArms(ContactBatch& batch, ManifoldLanes& m, int lane, Sides& s, const FreshLanes& fresh,
                          const RelativeLanes<W>& r, const M (&same)[2]) {
        const F localX = at(fresh.normalX + lane), localY = at(fresh.normalY + lane);
        s.setNormal(r.cosA * localX - r.sinA * localY, r.sinA * localX + r.cosA * localY);
        LaneArms<W> arms[2];
        for (int i = 0; i < 2; ++i) {
            const F x = at(fresh.points[i].x + lane), y = at(fresh.points[i].y + lane);
            const F rax = r.cosA * x - r.sinA * y, ray = r.sinA * x + r.cosA * y;
            arms[i] = s.arms(rax, ray, rax - r.apartX, ray - r.apartY);
        }
        const M still = rests<W>(batch, lane, arms, same);
        for (int i = 0; i < 2; ++i) {
            arms[i].replace(still, LaneArms<W>::of(batch.points[i], lane));
            arms[i].store(batch.points[i], lane);
        }
        const F nx = still ? at(batch.normalX + lane) : s.velocity.nx,
                ny = still ? at(batch.normalY + lane) : s.velocity.ny;
        s.setNormal(nx, ny);
        storeLanes(batch.normalX + lane, nx);
        storeLanes(batch.normalY + lane, ny);
        storeLanes(m.normalX + lane, localX);
        storeLanes(m.normalY + lane, localY);
    }

    static void prepare(ContactBatch& batch, ManifoldLanes& m, int lane, const BodyPlace* places,
                        const SolverVelocity* velocity, const FreshLanes& fresh, const StepLength& step) {
        const Matches found = matches(fresh, m, lane);
        carry(batch, m, lane, found, step);
        const RelativeLanes<W> r = relativeLanes<W>(batch.bodyA + lane, batch.bodyB + lane, places,
                                                    fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        Sides s = sides(batch, lane, places, velocity);
        placeArms(batch, m, lane, s, fresh, r, {found.same[0][0], found.same[1][1]});
        const I count = loadLanes<W>(fresh.count + lane);
        storeLanes(m.count + lane, count);
        storeLanes(batch.pushed + lane, I{});
        const F restitution = at(m.restitution + lane);
        F approach = F{};
        M clear = restitution > F{};
        for (int i = 0; i < 2; ++i) {
            const FreshPoint& point = fresh.points[i];
            const F separation = at(point.separation + lane);
            const M present = count > whole(i);
            const LaneArms<W> arms = LaneArms<W>::of(batch.points[i], lane);
            const F opening = preparePoint(batch.points[i], lane, s, arms, separation, restitution, present);
            const F speed = present ? -opening : F{};
            approach = larger(approach, speed);
            const M free = isClear(s, opening, separation, restitution, step.inverse);
            const M held = free ? M{} : present;
            clear = held ? M{} : clear;
            storeLanes(m.points[i].x + lane, at(point.x + lane));
            storeLanes(m.points[i].y + lane, at(point.y + lane));
            storeLanes(m.points[i].feature + lane, loadLanes<W>(point.feature + lane));
        }
        storeLanes(m.approachSpeed + lane, approach);
        const M some = count > I{};
        const M flies = some ? clear : M{};
        storeLanes(m.clear + lane, flies ? whole(1) : I{});
    }
};

}  // namespace plumb
