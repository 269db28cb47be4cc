// SPDX-License-Identifier: MIT
// Where does a disc touch a disc, a box, or a polygon of two to eight corners, rounded or not, for W pairs at a time?
//
// The result agrees with the manifold of collide/manifold.h: one point, on the line from the disc's centre to the
// nearest point of the other shape. If the centre is inside of it, the normal goes through the nearest face. A second
// disc is a box with half sizes 0 and a rounding radius.
// Tried: a disc that stays at the face that it is at counts as sure, and its manifold is not predicted. Scenes were not
// faster, and of 120 random ones two let a body out; without it, one of 360.
// Test: "discs side by side have the manifolds that they have one by one"
#pragma once
#include <limits>

#include <plumb/dynamics/contacts/lanes/classify_lanes.h>
#include <plumb/dynamics/contacts/lanes/polygon_cores.h>

namespace plumb {

template <int W>
struct DiscCollider {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;

    static F all(float value) { return F{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }

    /// The disc's centre in the frame of the other shape's body, and that shape as a box [m].
    struct View {
        F px, py, cx, cy, hx, hy;
    };

    /// Direction and distance from the other shape, without its rounding, to the disc's centre; negative inside [m].
    struct Nearest {
        F nx, ny, distance;
        F inset;  ///< how far the disc can slide along the face that it is at before it is at a corner [m]
    };

    static View view(const RelativeLanes<W>& r, const PairLanes& m, int lane, M boxIsB) {
        const F cax = at(m.centerXA + lane), cay = at(m.centerYA + lane);
        const F cbx = at(m.centerXB + lane), cby = at(m.centerYB + lane);
        View v;
        v.cx = boxIsB ? cbx : cax;
        v.cy = boxIsB ? cby : cay;
        const F x = cax - r.dx, y = cay - r.dy;
        v.px = boxIsB ? r.cos * x + r.sin * y : r.dx + (r.cos * cbx - r.sin * cby);
        v.py = boxIsB ? r.cos * y - r.sin * x : r.dy + (r.sin * cbx + r.cos * cby);
        v.hx = boxIsB ? at(m.halfXB + lane) : at(m.halfXA + lane);
        v.hy = boxIsB ? at(m.halfYB + lane) : at(m.halfYA + lane);
        return v;
    }

    static F within(F p, F half) { return larger(smaller(p, half), -half); }
    static F signOf(F p) {
        const M negative = p < F{};
        return negative ? all(-1) : all(1);
    }

    static Nearest nearestOfBox(const View& v) {
        constexpr float squaresUnderflow = 1e-18f;  // a centre nearer than this counts as inside
        const F px = v.px - v.cx, py = v.py - v.cy;
        const F dx = px - within(px, v.hx), dy = py - within(py, v.hy);
        const F distance = squareRoot<W>(dx * dx + dy * dy);
        const M outside = distance > all(squaresUnderflow);
        const F depthX = v.hx - magnitude(px), depthY = v.hy - magnitude(py);
        const M throughX = depthX < depthY;
        const F insideX = throughX ? signOf(px) : F{}, insideY = throughX ? F{} : signOf(py);
        Nearest n;
        n.nx = outside ? dx / distance : insideX;
        n.ny = outside ? dy / distance : insideY;
        n.distance = outside ? distance : -(throughX ? depthX : depthY);
        n.inset = larger(throughX ? depthY : depthX, F{});
        return n;
    }

    /// parted: size of the coordinates before they were made relative [m].
    static Nearest nearestOfPolygon(const View& v, const PolygonCores<W>& c, F parted) {
        const auto size = [](F x, F y) { return magnitude(x) + magnitude(y); };
        F face = all(-std::numeric_limits<float>::max()), nx{}, ny{}, sx{}, sy{}, ex{}, ey{};
        for (int i = 0; i < c.most; ++i) {
            const F outside = c.normalX[i] * (v.px - c.x[i]) + c.normalY[i] * (v.py - c.y[i]);
            const M better = both(M(c.count > I{} + i), M(outside > face));
            face = better ? outside : face;
            nx = better ? c.normalX[i] : nx;
            ny = better ? c.normalY[i] : ny;
            sx = better ? c.x[i] : sx;
            sy = better ? c.y[i] : sy;
            ex = better ? c.x[c.after(i)] : ex;
            ey = better ? c.y[c.after(i)] : ey;
        }
        const F startX = v.px - sx, startY = v.py - sy, endX = v.px - ex, endY = v.py - ey;
        const F afterStart = ny * -startX + nx * startY, beforeEnd = ny * endX - nx * endY;  // along the face
        const M isStart = afterStart < F{};
        const F cornerX = isStart ? startX : endX, cornerY = isStart ? startY : endY;
        const F distance = squareRoot<W>(cornerX * cornerX + cornerY * cornerY);
        // In line with a segment both its faces have separation 0: so not "face > 0".
        const F noise = lengthRoundings * (parted + size(sx, sy) + size(ex, ey));
        const F past = larger(-afterStart, -beforeEnd);
        const M outside = both(M(past > F{}), M(face > -noise)), corner = both(outside, M(distance > noise));
        return {corner ? cornerX / distance : nx, corner ? cornerY / distance : ny, corner ? distance : face,
                larger(-past, F{})};
    }

    static Nearest nearest(const View& v, const RelativeLanes<W>& r, const PairLanes& m, int lane, M boxIsB,
                           const CornerTable& table) {
        const Nearest box = nearestOfBox(v);
        const I corners = boxIsB ? loadLanes<W>(m.cornersB + lane) : loadLanes<W>(m.cornersA + lane);
        const M polygon = corners > I{};
        if (bitsOf<W>(polygon) == 0) return box;
        Lanes<std::int32_t> counts;
        Lanes<std::uint32_t> proxies;
        storeLanes(counts, corners);
        const std::uint32_t *proxyA = m.proxyA + lane, *proxyB = m.proxyB + lane;
        const std::int32_t* kernel = m.kernel + lane;
        for (int i = 0; i < W; ++i) proxies[i] = kernel[i] == discFirst ? proxyB[i] : proxyA[i];
        PolygonCores<W> cores;
        cores.load(counts, proxies, table);
        const Nearest other = nearestOfPolygon(v, cores, magnitude(r.dx) + magnitude(r.dy));
        return {polygon ? other.nx : box.nx, polygon ? other.ny : box.ny, polygon ? other.distance : box.distance,
                polygon ? other.inset : box.inset};
    }

    static void collide(const PairLanes& m, int lane, const BodyPlace* places, const CornerTable& table,
                        FreshLanes& fresh) {
        const I disc = loadLanes<W>(m.kernel + lane);
        const M boxIsB = disc == I{} + discFirst, discIsB = disc == I{} + discSecond;
        const M asked = boxIsB ? boxIsB : discIsB;
        if (bitsOf<W>(asked) == 0) return;
        const RelativeLanes<W> r =
            relativeLanes<W>(m.bodyA + lane, m.bodyB + lane, places, fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        const View v = view(r, m, lane, boxIsB);
        const Nearest n = nearest(v, r, m, lane, boxIsB, table);
        const F radiusA = at(m.radiusA + lane), radiusB = at(m.radiusB + lane);
        const F separation = n.distance - radiusA - radiusB;
        const F round = boxIsB ? radiusB : radiusA;
        const F shift =
            (round + separation * 0.5f) - n.distance;  // from the disc's centre to half-way between surfaces
        const F x = v.px + n.nx * shift, y = v.py + n.ny * shift;
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
        to.put(fresh.inset, n.inset);
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
