// SPDX-License-Identifier: MIT
// How are W hinges solved at once?
#pragma once
#include <plumb/collide/lanes/relative_lanes.h>
#include <plumb/dynamics/joints/hinge_solver.h>

namespace plumb {

template <int W>
struct WideHinges {
    using F = typename Wide<W>::Float;

    static constexpr F all(float value) { return F{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }

    /// An end's arm now, and how far its anchor has moved in this step.
    struct Arm {
        F x, y, travelX, travelY;
    };
    [[gnu::always_inline]] static inline Arm armOf(F startX, F startY, F inverseGyration, const Rows<W>& d) {
        const F sin = d.z * inverseGyration, cosMinus1 = d.w * inverseGyration;
        const F turnX = startX * cosMinus1 - startY * sin, turnY = startY * cosMinus1 + startX * sin;
        return {startX + turnX, startY + turnY, d.x + turnX, d.y + turnY};
    }

    /// How far an anchor's circular path leaves its tangent in the coming sub-step, divided by h. The angle is limited
    /// to a tenth of a radian: at larger angles, in a joint that is coming apart, the term would add to the error that
    /// it should correct.
    [[gnu::always_inline]] static inline F bendOf(F spin, F step) {
        const F angle = smaller(magnitude(spin * step), all(0.1f));
        return 0.5f * angle * angle / step;
    }

    [[gnu::always_inline]] static inline void push(Rows<W>& v, F x, F y, F armX, F armY, F inverseGyration) {
        v.x += v.w * x;
        v.y += v.w * y;
        v.z += v.w * inverseGyration * (armX * y - armY * x);
    }

    [[gnu::always_inline]] static inline void prepareLanes(HingeBatch& b, int lane, const BodyPlace* places) {
        const RelativeLanes<W> r = relativeLanes<W>(b.bodyA + lane, b.bodyB + lane, places);
        const Rows<W> angleA = loadRows<W, 16>(&places->highX + 4, b.bodyA + lane);
        const Rows<W> angleB = loadRows<W, 16>(&places->highX + 4, b.bodyB + lane);
        const F localXA = at(b.localXA + lane), localYA = at(b.localYA + lane);
        const F localXB = at(b.localXB + lane), localYB = at(b.localYB + lane);
        const F xa = angleA.x * localXA - angleA.y * localYA, ya = angleA.y * localXA + angleA.x * localYA;
        const F xb = angleB.x * localXB - angleB.y * localYB, yb = angleB.y * localXB + angleB.x * localYB;
        storeLanes(b.startXA + lane, xa);
        storeLanes(b.startYA + lane, ya);
        storeLanes(b.startXB + lane, xb);
        storeLanes(b.startYB + lane, yb);
        storeLanes(b.gapX + lane, r.apartX + (xb - xa));
        storeLanes(b.gapY + lane, r.apartY + (yb - ya));
        storeLanes(b.inverseGyrationA + lane, angleA.z);
        storeLanes(b.inverseGyrationB + lane, angleB.z);
        storeLanes(b.totalX + lane, F{});
        storeLanes(b.totalY + lane, F{});
    }

    [[gnu::always_inline]] static inline void warmLanes(const HingeBatch& b, int lane, const SolverBodies& bodies) {
        Rows<W> va = loadRows<W>(&bodies.velocity->x, b.bodyA + lane);
        Rows<W> vb = loadRows<W>(&bodies.velocity->x, b.bodyB + lane);
        const Rows<W> da = loadRows<W>(&bodies.displacement->x, b.bodyA + lane);
        const Rows<W> db = loadRows<W>(&bodies.displacement->x, b.bodyB + lane);
        const F inverseGyrationA = at(b.inverseGyrationA + lane), inverseGyrationB = at(b.inverseGyrationB + lane);
        const Arm ra = armOf(at(b.startXA + lane), at(b.startYA + lane), inverseGyrationA, da);
        const Arm rb = armOf(at(b.startXB + lane), at(b.startYB + lane), inverseGyrationB, db);
        const F x = at(b.impulseX + lane), y = at(b.impulseY + lane);
        push(va, -x, -y, ra.x, ra.y, inverseGyrationA);
        push(vb, x, y, rb.x, rb.y, inverseGyrationB);
        storeRows<W>(&bodies.velocity->x, b.bodyA + lane, va);
        storeRows<W>(&bodies.velocity->x, b.bodyB + lane, vb);
    }

    [[gnu::always_inline]] static inline void solveLanes(HingeBatch& b, int lane, const SolverBodies& bodies,
                                                         const HingePass& pass) {
        Rows<W> va = loadRows<W>(&bodies.velocity->x, b.bodyA + lane);
        Rows<W> vb = loadRows<W>(&bodies.velocity->x, b.bodyB + lane);
        const Rows<W> da = loadRows<W>(&bodies.displacement->x, b.bodyA + lane);
        const Rows<W> db = loadRows<W>(&bodies.displacement->x, b.bodyB + lane);
        const F inverseGyrationA = at(b.inverseGyrationA + lane), inverseGyrationB = at(b.inverseGyrationB + lane);
        const Arm ra = armOf(at(b.startXA + lane), at(b.startYA + lane), inverseGyrationA, da);
        const Arm rb = armOf(at(b.startXB + lane), at(b.startYB + lane), inverseGyrationB, db);
        const F spinA = va.z * inverseGyrationA, spinB = vb.z * inverseGyrationB;
        F wantedX = (vb.x - rb.y * spinB) - (va.x - ra.y * spinA);
        F wantedY = (vb.y + rb.x * spinB) - (va.y + ra.x * spinA);
        F massScale = all(1), impulseScale = F{};
        if (pass.correct) {
            const F step = all(pass.step);
            const F bendA = bendOf(spinA, step), bendB = bendOf(spinB, step);
            const F gapX = at(b.gapX + lane) + (rb.travelX - ra.travelX);
            const F gapY = at(b.gapY + lane) + (rb.travelY - ra.travelY);
            const F size = larger(squareRoot<W>(gapX * gapX + gapY * gapY), all(1e-9f));
            // Where the gap closes at the most allowed speed, the impulse must not leak: else a load opens it for ever.
            const F rate = smaller(all(pass.soft.biasRate), pass.fastest / size);
            wantedX += gapX * rate - (rb.x * bendB - ra.x * bendA);
            wantedY += gapY * rate - (rb.y * bendB - ra.y * bendA);
            massScale = all(pass.soft.massScale);
            impulseScale = rate < all(pass.soft.biasRate) ? F{} : all(pass.soft.impulseScale);
        }
        const F sxa = ra.x * inverseGyrationA, sya = ra.y * inverseGyrationA, sxb = rb.x * inverseGyrationB,
                syb = rb.y * inverseGyrationB;
        const F k11 = va.w * (1.0f + sya * sya) + vb.w * (1.0f + syb * syb);
        const F k12 = -va.w * sxa * sya - vb.w * sxb * syb;
        const F k22 = va.w * (1.0f + sxa * sxa) + vb.w * (1.0f + sxb * sxb);
        const F determinant = k11 * k22 - k12 * k12;
        const auto solvable = determinant > F{};
        const F inverse = solvable ? massScale / (solvable ? determinant : all(1)) : F{};
        const F oldX = at(b.impulseX + lane), oldY = at(b.impulseY + lane);
        const F x = -(k22 * wantedX - k12 * wantedY) * inverse - oldX * impulseScale;
        const F y = -(k11 * wantedY - k12 * wantedX) * inverse - oldY * impulseScale;
        storeLanes(b.impulseX + lane, oldX + x);
        storeLanes(b.impulseY + lane, oldY + y);
        storeLanes(b.totalX + lane, at(b.totalX + lane) + (oldX + x));
        storeLanes(b.totalY + lane, at(b.totalY + lane) + (oldY + y));
        push(va, -x, -y, ra.x, ra.y, inverseGyrationA);
        push(vb, x, y, rb.x, rb.y, inverseGyrationB);
        storeRows<W>(&bodies.velocity->x, b.bodyA + lane, va);
        storeRows<W>(&bodies.velocity->x, b.bodyB + lane, vb);
    }

    static void prepare(HingeBatch* batches, std::size_t count, const BodyPlace* places) {
        for (HingeBatch* batch = batches; batch != batches + count; ++batch)
            for (int lane = 0; lane < batchLanes; lane += W) prepareLanes(*batch, lane, places);
    }
    static void warmStart(const HingeBatch* batches, std::size_t count, const SolverBodies& bodies) {
        for (const HingeBatch* batch = batches; batch != batches + count; ++batch)
            for (int lane = 0; lane < batchLanes; lane += W) warmLanes(*batch, lane, bodies);
    }
    static void solve(HingeBatch* batches, std::size_t count, const SolverBodies& bodies, const HingePass& pass) {
        for (HingeBatch* batch = batches; batch != batches + count; ++batch)
            for (int lane = 0; lane < batchLanes; lane += W) solveLanes(*batch, lane, bodies, pass);
    }
};

template <int W>
const HingeSolver WideHingeSolver<W>::code{WideHinges<W>::prepare, WideHinges<W>::warmStart, WideHinges<W>::solve};

}  // namespace plumb
