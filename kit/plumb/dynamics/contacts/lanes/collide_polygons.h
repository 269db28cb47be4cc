// SPDX-License-Identifier: MIT
// Where do two polygons of two to eight corners touch, rounded or not, for W pairs at a time? A capsule or a segment is
// a polygon of two corners.
//
// The result agrees with the manifold of collide/manifold.h. The separating axis with the least overlap gives the
// reference edge (A's, if both are equally good), and the edge of the other shape that faces it is the incident edge.
// Test: "polygons side by side have the manifolds that they have one by one"
#pragma once
#include <plumb/collide/detail/facing_edges.h>
#include <plumb/dynamics/contacts/lanes/classify_lanes.h>
#include <plumb/dynamics/contacts/lanes/polygon_cores.h>

namespace plumb {

template <int W>
struct PolygonCollider {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;
    using Edges = FacingEdges<W>;
    using Cores = PolygonCores<W>;

    static constexpr float parallelCosine = 0.9999f;  ///< as in collide/detail/polygon_manifold.cpp

    static F all(float value) { return F{} + value; }
    static I whole(int value) { return I{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }
    static F size(F x, F y) { return magnitude(x) + magnitude(y); }

    /// An edge of each polygon, with a value by which it was chosen.
    struct Edge {
        F value;
        I index;
        F normalX, normalY, startX, startY, endX, endY;

        I after(I count) const {
            const I next = index + 1;
            return next < count ? next : I{};
        }
    };

    static void place(Cores& c, const RelativeLanes<W>& r) {
        const int end = c.most < mostCorners ? c.most + 1 : mostCorners;
        for (int i = 0; i < end; ++i) {
            const F x = c.x[i], y = c.y[i];
            c.x[i] = r.cos * x - r.sin * y + r.dx;
            c.y[i] = r.sin * x + r.cos * y + r.dy;
        }
        for (int i = 0; i < c.most; ++i) {
            const F x = c.normalX[i], y = c.normalY[i];
            c.normalX[i] = r.cos * x - r.sin * y;
            c.normalY[i] = r.sin * x + r.cos * y;
        }
    }

    static Edge firstEdge(const Cores& c, F value) {
        return {value, I{}, c.normalX[0], c.normalY[0], c.x[0], c.y[0], c.x[1], c.y[1]};
    }
    static void take(Edge& e, const Cores& c, int i, M better, F value) {
        const int next = c.after(i);
        e.value = better ? value : e.value;
        e.index = better ? whole(i) : e.index;
        e.normalX = better ? c.normalX[i] : e.normalX;
        e.normalY = better ? c.normalY[i] : e.normalY;
        e.startX = better ? c.x[i] : e.startX;
        e.startY = better ? c.y[i] : e.startY;
        e.endX = better ? c.x[next] : e.endX;
        e.endY = better ? c.y[next] : e.endY;
    }

    /// The edge of a that b is farthest outside of; the first of several.
    static Edge bestAxis(const Cores& a, const Cores& b) {
        Edge best;
        for (int i = 0; i < a.most; ++i) {
            const F nx = a.normalX[i], ny = a.normalY[i];
            F lowest = nx * b.x[0] + ny * b.y[0];
            for (int j = 1; j < b.most; ++j) lowest = smaller(nx * b.x[j] + ny * b.y[j], lowest);
            const F separation = lowest - (nx * a.x[i] + ny * a.y[i]);
            if (i == 0)
                best = firstEdge(a, separation);
            else
                take(best, a, i, both(M(a.count > whole(i)), M(separation > best.value)), separation);
        }
        return best;
    }

    /// The edge of the incident core that faces the normal: a's where onB, else b's.
    static Edge edgeFacing(F normalX, F normalY, M onB, const Cores& a, const Cores& b) {
        const auto against = [&](const Cores& c, int i) { return -(normalX * c.normalX[i] + normalY * c.normalY[i]); };
        Edge ofA = firstEdge(a, against(a, 0)), ofB = firstEdge(b, against(b, 0));
        for (int i = 1; i < a.most; ++i) {
            const F value = against(a, i);
            take(ofA, a, i, both(M(a.count > whole(i)), M(value > ofA.value)), value);
        }
        for (int i = 1; i < b.most; ++i) {
            const F value = against(b, i);
            take(ofB, b, i, both(M(b.count > whole(i)), M(value > ofB.value)), value);
        }
        return choose(onB, ofA, ofB);
    }

    static Edge choose(M m, const Edge& a, const Edge& b) {
        return {m ? a.value : b.value,   m ? a.index : b.index,   m ? a.normalX : b.normalX, m ? a.normalY : b.normalY,
                m ? a.startX : b.startX, m ? a.startY : b.startY, m ? a.endX : b.endX,       m ? a.endY : b.endY};
    }

    /// parted: size of the coordinates before they were made relative [m].
    static M usesB(const Edge& onA, const Edge& onB, F parted) {
        const F wholeA = size(onA.endX - onA.startX, onA.endY - onA.startY),
                wholeB = size(onB.endX - onB.startX, onB.endY - onB.startY);
        const F slack = lengthRoundings * (parted + size(onB.startX, onB.startY) + wholeA + wholeB) +
                        edgePreference * smaller(wholeA, wholeB);
        const M better = onB.value > onA.value, muchBetter = onB.value > onA.value + slack;
        const M parallel = onA.normalX * onB.normalX + onA.normalY * onB.normalY < all(-parallelCosine);
        return both(better, parallel ? muchBetter : better);
    }

    static Edges edgesOf(const Edge& reference, const Edge& incident, I count, I incidentCount, F parted) {
        Edges e;
        e.startX = reference.startX;
        e.startY = reference.startY;
        e.alongX = reference.endX - reference.startX;
        e.alongY = reference.endY - reference.startY;
        e.normalX = reference.normalX;
        e.normalY = reference.normalY;
        e.highX = incident.startX;
        e.highY = incident.startY;
        e.lowX = incident.endX;
        e.lowY = incident.endY;
        e.edge = e.start = reference.index;
        e.end = reference.after(count);
        e.incidentEdge = e.high = incident.index;
        e.low = incident.after(incidentCount);
        const F length = size(e.alongX, e.alongY), incidentLength = size(e.highX - e.lowX, e.highY - e.lowY);
        e.rounding = lengthRoundings * (parted + size(e.startX, e.startY) + length + incidentLength);
        e.slack = e.rounding + edgePreference * smaller(length, incidentLength);
        return e;
    }

    static void store(const TouchingEdges<W>& touch, M useB, const Reaching<W>& reach, LaneWriter<W> to) {
        const F normalX = useB ? -touch.normalX : touch.normalX, normalY = useB ? -touch.normalY : touch.normalY;
        to.put(to.fresh.normalX, normalX);
        to.put(to.fresh.normalY, normalY);
        to.put(to.fresh.count, reach.count);
        to.put(to.fresh.uncertain, reach.uncertain);
        to.put(to.fresh.inset, F{});
        for (int p = 0; p < 2; ++p) {
            const auto& point = touch.points[p];
            FreshPoint& out = to.fresh.points[p];
            const I first = useB ? point.incident : point.reference, second = useB ? point.reference : point.incident;
            const F shift = reach.shiftToPlace(point.separation);
            to.put(out.x, point.x + normalX * shift);
            to.put(out.y, point.y + normalY * shift);
            to.put(out.separation, point.separation);
            to.put(out.feature, I((first << 8) | second));
        }
    }

    static void collide(const PairLanes& m, int lane, const BodyPlace* places, const CornerTable& table,
                        const std::int32_t* wanted, FreshLanes& fresh) {
        const M asked = loadLanes<W>(wanted + lane) != I{};
        if (bitsOf<W>(asked) == 0) return;
        const RelativeLanes<W> r =
            relativeLanes<W>(m.bodyA + lane, m.bodyB + lane, places, fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        Cores a, b;
        a.load(m.cornersA + lane, m.proxyA + lane, table);
        b.load(m.cornersB + lane, m.proxyB + lane, table);
        place(b, r);
        const F radiusA = at(m.radiusA + lane), radiusB = at(m.radiusB + lane), parted = size(r.dx, r.dy);
        const Edge onA = bestAxis(a, b), onB = bestAxis(b, a);
        const M useB = usesB(onA, onB, parted);
        const Edge reference = choose(useB, onB, onA);
        Edges edges = edgesOf(reference, edgeFacing(reference.normalX, reference.normalY, useB, a, b),
                              useB ? b.count : a.count, useB ? a.count : b.count, parted);
        edges.radius = useB ? radiusB : radiusA;
        edges.incidentRadius = useB ? radiusA : radiusB;
        const F margin = marginOf<W>(r), separation = larger(onA.value, onB.value);
        const TouchingEdges<W> touch = edges.meet(separation > -edges.rounding, margin);
        const M near = separation <= margin + radiusA + radiusB;
        const F first = touch.points[0].separation, second = touch.points[1].separation;
        const F nearest = touch.count > whole(1) ? smaller(first, second) : first;
        const I count = near ? touch.count : I{};
        Reaching<W> reach = reachOf<W>(r, useB ? -touch.normalX : touch.normalX, useB ? -touch.normalY : touch.normalY,
                                       nearest, count, touch.play);
        const M chain = loadLanes<W>(m.kernel + lane) == whole(onChain);  // it may meet in another direction
        reach.count = chain ? count : reach.count;
        store(touch, useB, reach, {fresh, lane, asked});
    }
};

}  // namespace plumb
