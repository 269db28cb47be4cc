// SPDX-License-Identifier: MIT
// Which manifolds are still right, because the two bodies have hardly moved relative to each other since they were
// computed? Their points keep their places on A, and their separations follow the motion of B's points.
//
// Tried: 1 mm in place of 0.2 mm made heaps no faster. Boxes are not asked: to collide them takes as long.
// Source: contact recycling in Box2D 3.2, which allows a motion of 5 cm.
#pragma once
#include <plumb/collide/lanes/classify_lanes.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

template <int W>
struct LaneReuser {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;

    /// Since then, a point of B may have moved by this [m], and by this share of the smaller shape's size [-].
    static constexpr float farthest = 2e-4f, farthestShare = 0.01f;
    static constexpr float farthestTurn = 2e-3f;  ///< of B relative to A [rad]
    static constexpr float turnOfNormal = 1e-3f;  ///< of the normal between two corners [rad]
    static constexpr float fast = 5e-3f;          ///< what moves farther in the step is collided again [m]
    static constexpr int edges = 0x8080;  ///< in a feature: an edge takes part (see collide/detail/core_manifold.h)

    static F all(float value) { return F{} + value; }
    static I whole(int value) { return I{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }
    static I one(M m) { return m ? whole(1) : I{}; }

    static F sizeOf(const float* halfX, const float* halfY, const float* radius) {
        return larger(at(halfX), at(halfY)) + at(radius);
    }

    /// Fills fresh with the kept manifolds; again: not 0 where they are wrong. now: the places of this step.
    static void reuse(const PairLanes& pairs, int lane, const BodyPlace* places, const ManifoldLanes& manifolds,
                      const KeptLanes& kept, FreshLanes& fresh, PoseLanes& now, std::int32_t* again) {
        const RelativeLanes<W> r = relativeLanes<W>(pairs.bodyA + lane, pairs.bodyB + lane, places,
                                                    fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        storeLanes(now.x + lane, r.dx);
        storeLanes(now.y + lane, r.dy);
        storeLanes(now.cos + lane, r.cos);
        storeLanes(now.sin + lane, r.sin);
        const F x0 = at(kept.pose.x + lane), y0 = at(kept.pose.y + lane);
        const F cos0 = at(kept.pose.cos + lane), sin0 = at(kept.pose.sin + lane);
        // B's turn relative to A since then. Cosine and sine 0 of a manifold that was not kept give 0 here, and so
        // unknown.
        const F cos = r.cos * cos0 + r.sin * sin0, sin = r.sin * cos0 - r.cos * sin0;
        const F nx = at(manifolds.normalX + lane), ny = at(manifolds.normalY + lane);
        const F radii = at(pairs.radiusA + lane) + at(pairs.radiusB + lane);
        const F size = smaller(sizeOf(pairs.halfXA + lane, pairs.halfYA + lane, pairs.radiusA + lane),
                               sizeOf(pairs.halfXB + lane, pairs.halfYB + lane, pairs.radiusB + lane));
        const F allowed = smaller(all(farthest), size * farthestShare);
        const I count = loadLanes<W>(manifolds.count + lane);
        const F shift = r.shiftX * r.shiftX + r.shiftY * r.shiftY;
        const M turned = magnitude(sin) > all(farthestTurn), unknown = cos<all(0.5f), quick = shift> all(fast * fast),
                spins = r.turn > all(fast), none = count == I{};
        I bad = one(turned) | one(unknown) | one(quick) | one(spins) | one(none);
        for (int p = 0; p < 2; ++p) {
            const ManifoldPointLanes& point = manifolds.points[p];
            FreshPoint& out = fresh.points[p];
            const F x = at(point.x + lane), y = at(point.y + lane);
            // How far B's point has come in A's frame, d = R(turn) (p - b0) + b - p: p the point, b0 and b B's centre
            // then and now. The separation changes by n.d, to first order.
            const F armX = x - x0, armY = y - y0;
            const F moveX = (cos * armX - sin * armY) + (r.dx - x), moveY = (sin * armX + cos * armY) + (r.dy - y);
            const F separation = at(kept.separations[p] + lane) + (nx * moveX + ny * moveY);
            const I feature = loadLanes<W>(point.feature + lane);
            const M corners = (feature & whole(edges)) == I{};
            // Between two corners, a move d aside turns the normal by d / distance: within turnOfNormal it is right.
            const F distance = larger(separation + radii, F{}) * turnOfNormal;
            const F most = corners ? smaller(distance, allowed) : allowed;
            const M moved = moveX * moveX + moveY * moveY > most * most, apart = separation > all(contactMargin);
            const M there = count > whole(p);
            bad |= there ? one(moved) | one(apart) : I{};
            storeLanes(out.x + lane, x);
            storeLanes(out.y + lane, y);
            storeLanes(out.separation + lane, separation);
            storeLanes(out.feature + lane, feature);
        }
        storeLanes(fresh.normalX + lane, nx);
        storeLanes(fresh.normalY + lane, ny);
        storeLanes(fresh.count + lane, count);
        storeLanes(fresh.uncertain + lane, I{});
        storeLanes(fresh.inset + lane, F{});
        storeLanes(again + lane, bad);
    }
};

}  // namespace plumb
