// SPDX-License-Identifier: MIT
// Where do two boxes touch, for W pairs at a time?
//
// The result agrees with the manifold of collide/manifold.h for boxes without rounding. The separating axis with the
// least overlap gives the reference face (A's face, if both boxes are equally good). The incident face, which is the
// other box's face that faces it, is clipped to its length. If the nearest features are two corners, the line between
// them is the normal.
// Test: "boxes side by side have the manifolds that they have one by one"
#pragma once
#include <plumb/collide/lanes/classify_lanes.h>

namespace plumb {

template <int W>
struct BoxCollider {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;

    static constexpr float favour = 1e-4f;    ///< B's face must be better by this share of the smaller box's size
    static constexpr float facing = 0.9999f;  ///< faces count as parallel if the cosine of their angle is larger
    static constexpr float rounding = 8 * 1.1920929e-7f;
    static constexpr int edgeBit = 0x80;  ///< features as in collide/detail/core_manifold.h

    static F all(float value) { return F{} + value; }
    static I whole(int value) { return I{} + value; }
    static F at(const float* lanes) { return loadLanes<W>(lanes); }

    /// Half sizes and relative place in the frame of the reference box.
    struct View {
        M useB;
        F hx, hy, ihx, ihy;  ///< half sizes of the reference box and of the incident box [m]
        F px, py;            ///< from the reference box's centre to the incident box's centre [m]
        F sin;               ///< of the incident box's angle relative to the reference; the cosine needs no sign change
        M usesX;             ///< the reference face is perpendicular to x
        F separation;        ///< along the best axis of both boxes [m]
        F noise, slack;      ///< lengths below noise are rounding errors; those below slack make no difference [m]
    };

    /// The reference face with normal n and tangent t = perp(n), and the ends of the incident edge in that frame,
    /// measured from the face.
    struct Faces {
        F nx, ny, hn, ht;
        F lowT, lowN, highT, highN;
        I edge, incidentEdge;
    };

    struct Point {
        F t, n;
        I feature;
    };

    struct Result {
        F normalN, normalT;  ///< the manifold's normal, in the reference face's frame
        Point points[2];
        M two;     ///< there are two points
        M corner;  ///< the nearest features are two corners
        F length;  ///< length of the part that the faces share [m]
    };

    static View view(const RelativeLanes<W>& r, const PairLanes& m, int lane) {
        const F ra = at(m.radiusA + lane), rb = at(m.radiusB + lane);
        const F hax = at(m.halfXA + lane) + ra, hay = at(m.halfYA + lane) + ra;
        const F hbx = at(m.halfXB + lane) + rb, hby = at(m.halfYB + lane) + rb;
        const F cbx = at(m.centerXB + lane), cby = at(m.centerYB + lane);
        const F px = (r.dx + (r.cos * cbx - r.sin * cby)) - at(m.centerXA + lane);
        const F py = (r.dy + (r.sin * cbx + r.cos * cby)) - at(m.centerYA + lane);
        const F qx = -(r.cos * px + r.sin * py), qy = r.sin * px - r.cos * py;
        const F ac = magnitude(r.cos), as = magnitude(r.sin);
        const F ax = (magnitude(px) - hax) - (ac * hbx + as * hby);
        const F ay = (magnitude(py) - hay) - (as * hbx + ac * hby);
        const F bx = (magnitude(qx) - hbx) - (ac * hax + as * hay);
        const F by = (magnitude(qy) - hby) - (as * hax + ac * hay);
        const M aUsesX = ax > ay, bUsesX = bx > by;
        const F sepA = aUsesX ? ax : ay, sepB = bUsesX ? bx : by;
        const F sizes = (hax + hay) + (hbx + hby);
        const F noise = (magnitude(r.dx) + magnitude(r.dy) + 3 * sizes) * rounding;
        const F slack = noise + smaller(smaller(hax, hay), smaller(hbx, hby)) * (2 * favour);
        const M across = M(aUsesX ^ bUsesX);
        const F along = across ? as : ac;
        const M better = sepB > sepA, muchBetter = sepB > sepA + slack, aslant = along < all(facing);
        const M enough = aslant ? better : muchBetter;
        View v;
        v.useB = better ? enough : M{};
        v.hx = v.useB ? hbx : hax;
        v.hy = v.useB ? hby : hay;
        v.ihx = v.useB ? hax : hbx;
        v.ihy = v.useB ? hay : hby;
        v.px = v.useB ? qx : px;
        v.py = v.useB ? qy : py;
        v.sin = v.useB ? -r.sin : r.sin;
        v.usesX = v.useB ? bUsesX : aUsesX;
        v.separation = larger(sepA, sepB);
        v.noise = noise;
        v.slack = slack;
        return v;
    }

    /// Edges and corners are numbered as in boxPolygon(): counterclockwise from the lower left corner.
    static I edgeIndex(M usesX, M negative) {
        const I acrossX = negative ? whole(3) : whole(1);
        const I acrossY = negative ? whole(0) : whole(2);
        return usesX ? acrossX : acrossY;
    }
    static I next(I corner) { return (corner + 1) & 3; }

    static Faces faces(const View& v, F cos) {
        Faces f;
        const F deep = v.usesX ? v.px : v.py;
        const M negative = deep < F{};
        const F sign = negative ? all(-1) : all(1);
        f.nx = v.usesX ? sign : F{};
        f.ny = v.usesX ? F{} : sign;
        f.hn = v.usesX ? v.hx : v.hy;
        f.ht = v.usesX ? v.hy : v.hx;
        f.edge = edgeIndex(v.usesX, negative);
        const F dn = v.px * f.nx + v.py * f.ny, dt = v.py * f.nx - v.px * f.ny;
        // the incident box's x axis is (un, ut) here, and its y axis (-ut, un)
        const F un = cos * f.nx + v.sin * f.ny, ut = v.sin * f.nx - cos * f.ny;
        const M acrossX = magnitude(un) >= magnitude(ut);
        const F fn = acrossX ? un : -ut, ft = acrossX ? ut : un;
        const M flip = fn > F{};
        const F mn = flip ? -fn : fn, mt = flip ? -ft : ft;
        const F hm = acrossX ? v.ihx : v.ihy, he = acrossX ? v.ihy : v.ihx;
        f.incidentEdge = edgeIndex(acrossX, flip);
        const F cn = (dn - f.hn) + mn * hm, ct = dt + mt * hm;
        f.lowT = ct + mn * he;
        f.lowN = cn - mt * he;
        f.highT = ct - mn * he;
        f.highN = cn + mt * he;
        return f;
    }

    static I feature(M useB, I reference, I incident) {
        const I first = useB ? incident : reference;
        const I second = useB ? reference : incident;
        return (first << 8) | second;
    }

    static F beyond(F t, F end) { return t - larger(smaller(t, end), -end); }

    /// The feature of an end of the incident edge. If the reference face clips it, this holds the clipping corner of
    /// the reference face and the incident edge, else the reference edge and the incident corner.
    static I nameOf(const View& v, const Faces& f, F cut, I referenceCorner, I incidentCorner) {
        const M cuts = cut > v.slack;
        const I edge = f.edge | whole(edgeBit), incidentEdge = f.incidentEdge | whole(edgeBit);
        const I reference = cuts ? referenceCorner : edge;
        const I incident = cuts ? incidentEdge : incidentCorner;
        return feature(v.useB, reference, incident);
    }

    static F shareOf(F cut, F width, F noise) {
        const F share = smaller(cut / width, all(1));
        return cut > noise ? share : F{};
    }

    static Result meet(const View& v, const Faces& f) {
        const F ht = f.ht;
        const F lowGap = beyond(f.lowT, ht), highGap = beyond(f.highT, ht);
        const F lowSquared = lowGap * lowGap + f.lowN * f.lowN, highSquared = highGap * highGap + f.highN * f.highN;
        const M lowNearer = lowSquared < highSquared;
        const F gapT = lowNearer ? lowGap : highGap, gapN = lowNearer ? f.lowN : f.highN;
        const F squared = lowNearer ? lowSquared : highSquared;
        const F width = f.highT - f.lowT, rise = f.highN - f.lowN;
        const F forward = gapT * width + gapN * rise;
        const F towards = lowNearer ? forward : -forward;
        const M outside = gapT != F{}, apart = squared > v.noise * v.noise, away = towards >= F{};
        const M parted = v.separation > -v.noise;
        const M looksAway = away ? apart : M{};
        const M facesCorner = outside ? looksAway : M{};
        Result result;
        result.corner = parted ? facesCorner : M{};
        const M corner = result.corner;
        const F distance = squareRoot<W>(squared);

        const F cutLow = -ht - f.lowT, cutHigh = f.highT - ht;
        const F shareLow = shareOf(cutLow, width, v.noise), shareHigh = shareOf(cutHigh, width, v.noise);
        const I startCorner = f.edge, endCorner = next(f.edge);
        const I lowCorner = next(f.incidentEdge), highCorner = f.incidentEdge;
        const Point low{f.lowT + shareLow * width, f.lowN + shareLow * rise,
                        nameOf(v, f, cutLow, startCorner, lowCorner)};
        const Point high{f.highT - shareHigh * width, f.highN - shareHigh * rise,
                         nameOf(v, f, cutHigh, endCorner, highCorner)};
        result.length = high.t - low.t;
        const M single = result.length <= v.slack, highLower = low.n >= high.n;
        const M useHigh = single ? highLower : M{};
        const M before = gapT < F{};
        const I nearCorner = before ? startCorner : endCorner, incidentCorner = lowNearer ? lowCorner : highCorner;
        const I cornerFeature = feature(v.useB, nearCorner, incidentCorner);
        const F cornerT = before ? -ht : ht;
        const F t = useHigh ? high.t : low.t, n = useHigh ? high.n : low.n;
        const I name = useHigh ? high.feature : low.feature;
        result.normalN = corner ? gapN / distance : all(1);
        result.normalT = corner ? gapT / distance : F{};
        result.points[0].t = corner ? cornerT : t;
        result.points[0].n = corner ? distance : n;
        result.points[0].feature = corner ? cornerFeature : name;
        result.points[1] = high;
        const M many = result.length > v.slack;
        result.two = corner ? M{} : many;
        return result;
    }

    /// Transforms directions and points from the reference box's frame to A's frame, with its origin in A's centre of
    /// mass.
    struct ToA {
        const RelativeLanes<W>& r;
        M useB;
        F cx, cy;  ///< centre of the reference box in its body's frame [m]
        void turn(F& x, F& y) const {
            const F tx = r.cos * x - r.sin * y, ty = r.sin * x + r.cos * y;
            x = useB ? tx : x;
            y = useB ? ty : y;
        }
        void place(F& x, F& y) const {
            x += cx;
            y += cy;
            turn(x, y);
            x = useB ? x + r.dx : x;
            y = useB ? y + r.dy : y;
        }
    };

    static void collide(const PairLanes& m, int lane, const BodyPlace* places, FreshLanes& fresh) {
        const RelativeLanes<W> r =
            relativeLanes<W>(m.bodyA + lane, m.bodyB + lane, places, fresh.apartXFrom(lane), fresh.apartYFrom(lane));
        const View v = view(r, m, lane);
        const Faces f = faces(v, r.cos);
        const Result result = meet(v, f);
        const F cxA = at(m.centerXA + lane), cyA = at(m.centerYA + lane);
        const F cxB = at(m.centerXB + lane), cyB = at(m.centerYB + lane);
        const ToA toA{r, v.useB, v.useB ? cxB : cxA, v.useB ? cyB : cyA};
        const F nn = result.normalN, nt = result.normalT;
        F normalX = nn * f.nx - nt * f.ny, normalY = nn * f.ny + nt * f.nx;
        toA.turn(normalX, normalY);
        normalX = v.useB ? -normalX : normalX;
        normalY = v.useB ? -normalY : normalY;
        storeLanes(fresh.normalX + lane, normalX);
        storeLanes(fresh.normalY + lane, normalY);

        const F margin = marginOf<W>(r);
        const M in0 = result.points[0].n <= margin, near1 = result.points[1].n <= margin;
        const M in1 = result.two ? near1 : M{};
        const M useSecond = in0 ? M{} : in1;
        const F nearest0 = in0 ? result.points[0].n : result.points[1].n;
        const F nearest = in1 ? smaller(nearest0, result.points[1].n) : nearest0;
        const I count0 = in0 ? whole(1) : I{}, count1 = in1 ? whole(1) : I{};
        const Reaching<W> reach =
            reachOf<W>(r, normalX, normalY, nearest, count0 + count1, result.corner ? F{} : result.length);
        storeLanes(fresh.count + lane, reach.count);
        storeLanes(fresh.uncertain + lane, reach.uncertain);
        storeLanes(fresh.inset + lane, F{});
        for (int i = 0; i < 2; ++i) {
            const Point& own = result.points[i];
            const Point& second = result.points[1];
            const F t = useSecond ? second.t : own.t, n = useSecond ? second.n : own.n;
            const F onT = t + nt * n * 0.5f, onN = f.hn + nn * n * 0.5f;
            F x = onN * f.nx - onT * f.ny, y = onN * f.ny + onT * f.nx;
            toA.place(x, y);
            const F shift = reach.shiftToPlace(n);
            FreshPoint& out = fresh.points[i];
            storeLanes(out.x + lane, x + normalX * shift);
            storeLanes(out.y + lane, y + normalY * shift);
            storeLanes(out.separation + lane, n);
            storeLanes(out.feature + lane, useSecond ? second.feature : own.feature);
        }
    }
};

}  // namespace plumb
