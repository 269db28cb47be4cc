// SPDX-License-Identifier: MIT
// Where does a disc touch a disc, or a box with or without a rounding radius, for W pairs at a time?
//
// The result agrees with the manifold of collide/manifold.h: one point, on the line from the disc's centre to the
// nearest point of the box. If the centre is inside the box, the normal goes through the nearest face. A second disc is
// a box with half sizes 0 and a rounding radius.
// Test: "discs side by side have the manifolds that they have one by one"
#pragma once
#include <plumb/dynamics/contacts/lanes/classify_lanes.h>

namespace plumb {

template <int W>
struct DiscCollider {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;

    static F all(float value) { return F{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }

    /// The disc's centre relative to the box's centre, in the box's frame, and the box's half sizes [m].
    struct View {
        F px, py, hx, hy;
    };

    /// Direction and distance from the box, without its rounding, to the disc's centre; negative inside [m].
    struct Nearest {
        F nx, ny, distance;
    };

    static View view(const RelativeLanes<W>& r, const PairLanes& m, int lane, M boxIsB) {
        const F cax = at(m.centerXA + lane), cay = at(m.centerYA + lane);
        const F cbx = at(m.centerXB + lane), cby = at(m.centerYB + lane);
        const F fromAX = (r.dx + (r.cos * cbx - r.sin * cby)) - cax,
                fromAY = (r.dy + (r.sin * cbx + r.cos * cby)) - cay;
        View v;
        v.px = boxIsB ? -(r.cos * fromAX + r.sin * fromAY) : fromAX;
        v.py = boxIsB ? r.sin * fromAX - r.cos * fromAY : fromAY;
        v.hx = boxIsB ? at(m.halfXB + lane) : at(m.halfXA + lane);
        v.hy = boxIsB ? at(m.halfYB + lane) : at(m.halfYA + lane);
        return v;
    }

    static F within(F p, F half) { return larger(smaller(p, half), -half); }
    static F signOf(F p) {
        const M negative = p < F{};
        return negative ? all(-1) : all(1);
    }

    static Nearest nearest(const View& v) {
        constexpr float squaresUnderflow = 1e-18f;  // a centre nearer than this counts as inside
        const F dx = v.px - within(v.px, v.hx), dy = v.py - within(v.py, v.hy);
        const F distance = squareRoot<W>(dx * dx + dy * dy);
        const M outside = distance > all(squaresUnderflow);
        const F depthX = v.hx - magnitude(v.px), depthY = v.hy - magnitude(v.py);
        const M throughX = depthX < depthY;
        const F insideX = throughX ? signOf(v.px) : F{}, insideY = throughX ? F{} : signOf(v.py);
        const F depth = throughX ? depthX : depthY;
        Nearest n;
        n.nx = outside ? dx / distance : insideX;
        n.ny = outside ? dy / distance : insideY;
        n.distance = outside ? distance : -depth;
        return n;
    }

    static void collide(const PairLanes& m, int lane, const BodyPlace* places, FreshLanes& fresh) {
        const I disc = loadLanes<W>(m.kernel + lane);
        const M boxIsB = disc == I{} + discFirst, discIsB = disc == I{} + discSecond;
        const M asked = boxIsB ? boxIsB : discIsB;
        if (bitsOf<W>(asked) == 0) return;
        const RelativeLanes<W> r =
            relativeLanes<W>(m.bodyA + lane, m.bodyB + lane, places, fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        const View v = view(r, m, lane, boxIsB);
        const Nearest n = nearest(v);
        const F radiusA = at(m.radiusA + lane), radiusB = at(m.radiusB + lane);
        const F separation = n.distance - radiusA - radiusB;
        const F round = boxIsB ? radiusB : radiusA;
        const F way = (round + separation * 0.5f) - n.distance;  // from the disc's centre to half-way between surfaces
        const F ownX = v.px + n.nx * way, ownY = v.py + n.ny * way;
        const F x = ownX + (boxIsB ? at(m.centerXB + lane) : at(m.centerXA + lane));
        const F y = ownY + (boxIsB ? at(m.centerYB + lane) : at(m.centerYA + lane));
        const F turnedX = (r.cos * x - r.sin * y) + r.dx, turnedY = (r.sin * x + r.cos * y) + r.dy;
        const F normalX = boxIsB ? -(r.cos * n.nx - r.sin * n.ny) : n.nx;
        const F normalY = boxIsB ? -(r.sin * n.nx + r.cos * n.ny) : n.ny;
        const M near = separation <= marginOf<W>(r);
        const Reaching<W> reach = reachOf<W>(r, normalX, normalY, separation, near ? I{} + 1 : I{}, F{});
        const LaneWriter<W> to{fresh, lane, asked};
        to.put(fresh.normalX, normalX);
        to.put(fresh.normalY, normalY);
        to.put(fresh.count, reach.count);
        to.put(fresh.uncertain, reach.uncertain);
        FreshPoint &point = fresh.points[0], &none = fresh.points[1];
        to.put(point.x, boxIsB ? turnedX : x);
        to.put(point.y, boxIsB ? turnedY : y);
        to.put(point.separation, separation);
        to.put(point.feature, I{});
        to.put(none.x, F{});
        to.put(none.y, F{});
        to.put(none.separation, F{});
        to.put(none.feature, I{});
    }
};

}  // namespace plumb
