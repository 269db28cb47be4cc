// SPDX-License-Identifier: MIT
// Where do two edges touch that face each other, for W pairs at a time? The last part of each manifold of two polygons.
//
// If the shapes are separated, and their nearest features are two corners, the line between these is the normal, and
// there is one point. Otherwise the normal is the reference edge's, and the points are the ends of the stretch that
// both edges have in common.
#pragma once
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

/// How much better B's edge must be than A's parallel edge to be preferred, as a share of the shorter of the two: far
/// more than the jitter of a stack at rest (1e-6), far less than what is visible. Two points closer than this are one
/// point.
inline constexpr float edgePreference = 1e-4f;

template <int W>
struct TouchingEdges {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;
    struct Point {
        F x, y, separation;     ///< half way between the surfaces [m]
        I reference, incident;  ///< feature codes (see core_manifold.h)
    };
    F normalX, normalY;  ///< out of the reference shape
    Point points[2];
    I count;   ///< of points within the margin
    M corner;  ///< the nearest features are two corners
    F play;    ///< by how far they may slide along each other before the nearest features are others; 0 at corners [m]
};

/// A reference edge and an incident edge in one frame. They run in opposite directions: the incident edge starts at its
/// high end, which is nearer to the reference edge's end.
template <int W>
struct FacingEdges {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;
    static constexpr int edgeBit = 0x80;  ///< as in core_manifold.h

    F startX, startY, alongX, alongY;  ///< of the reference edge: its start, and the way from there to its end [m]
    F normalX, normalY;                ///< of the reference edge, outward
    F highX, highY, lowX, lowY;        ///< ends of the incident edge [m]
    I edge, start, end;                ///< numbers of the reference edge and of its corners
    I incidentEdge, high, low;         ///< numbers of the incident edge and of its corners
    F radius, incidentRadius;          ///< around the two cores [m]
    F rounding;                        ///< lengths below this are rounding errors [m]
    F slack;                           ///< lengths below this are insignificant [m]

    /// A point of the incident edge.
    struct EdgePoint {
        F along, above;         ///< from the reference edge's start towards its end, and out of it [m]
        I reference, incident;  ///< feature codes
    };
    /// Two corners that are nearest to each other.
    struct CornerPair {
        M found, atStart;            ///< atStart: of the reference edge
        F gapAlong, gapAbove, size;  ///< from the reference corner to the other [m]
        I incident;
    };

    static F all(float value) { return F{} + value; }
    static I whole(int value) { return I{} + value; }

    EdgePoint seen(F x, F y, I corner) const {
        const F dx = x - startX, dy = y - startY;
        return {normalX * dy - normalY * dx, normalX * dx + normalY * dy, edge | whole(edgeBit), corner};
    }

    static EdgePoint choose(M m, const EdgePoint& a, const EdgePoint& b) {
        return {m ? a.along : b.along, m ? a.above : b.above, m ? a.reference : b.reference,
                m ? a.incident : b.incident};
    }

    /// Clips an end of the incident edge at a corner of the reference edge, if it extends beyond that by excess. The
    /// point is then identified by that corner and the incident edge, as it would be with the roles exchanged. An
    /// insignificant excess leaves the name as it is: a box that sits flush on an equal box and jitters keeps its
    /// impulses.
    EdgePoint clipped(const EdgePoint& from, const EdgePoint& other, F excess, I corner) const {
        const F width = other.along - from.along;
        const F part = smaller(excess / magnitude(width), all(1));
        const M cuts = excess > rounding, farther = excess > slack;
        const M named = both(cuts, farther);
        return {cuts ? from.along + part * width : from.along,
                cuts ? from.above + part * (other.above - from.above) : from.above, named ? corner : from.reference,
                named ? incidentEdge | whole(edgeBit) : from.incident};
    }

    /// The two corners that are nearest to each other, if they are apart and neither is nearest to the other's edge.
    CornerPair facingCorners(const EdgePoint& lowEnd, const EdgePoint& highEnd, F length) const {
        const F lowGap = lowEnd.along - larger(smaller(lowEnd.along, length), F{});
        const F highGap = highEnd.along - larger(smaller(highEnd.along, length), F{});
        const F lowSquared = lowGap * lowGap + lowEnd.above * lowEnd.above;
        const F highSquared = highGap * highGap + highEnd.above * highEnd.above;
        const M lowNearer = lowSquared < highSquared;
        const EdgePoint near = choose(lowNearer, lowEnd, highEnd), far = choose(lowNearer, highEnd, lowEnd);
        const F squared = lowNearer ? lowSquared : highSquared;
        CornerPair pair;
        pair.gapAlong = lowNearer ? lowGap : highGap;
        pair.gapAbove = near.above;
        pair.size = squareRoot<W>(squared);
        pair.atStart = pair.gapAlong < F{};
        pair.incident = near.incident;
        const F towards = pair.gapAlong * (far.along - near.along) + pair.gapAbove * (far.above - near.above);
        const M outside = pair.gapAlong != F{}, apart = squared > rounding * rounding, away = !(towards < F{});
        pair.found = both(both(outside, apart), away);
        return pair;
    }

    /// mayBeCorners: the shapes are not known to overlap.
    TouchingEdges<W> meet(M mayBeCorners, F margin) const {
        const F tangentX = -normalY, tangentY = normalX;
        const F length = tangentX * alongX + tangentY * alongY;
        const EdgePoint lowEnd = seen(lowX, lowY, low), highEnd = seen(highX, highY, high);
        const CornerPair corners = facingCorners(lowEnd, highEnd, length);
        TouchingEdges<W> touch;
        touch.corner = both(mayBeCorners, corners.found);
        const M corner = touch.corner;

        const M upright = highEnd.along - lowEnd.along <= slack;
        const EdgePoint cutLow = choose(upright, lowEnd, clipped(lowEnd, highEnd, -lowEnd.along, start));
        const EdgePoint cutHigh = choose(upright, highEnd, clipped(highEnd, lowEnd, highEnd.along - length, end));
        const F common = cutHigh.along - cutLow.along;
        const M single = common <= slack, isHigh = !(cutLow.above < cutHigh.above);
        const EdgePoint lower = choose(both(single, isHigh), cutHigh, cutLow);
        const F nearest = isHigh ? cutHigh.along : cutLow.along;
        touch.play = corner ? F{} : larger(common, smaller(nearest, length - nearest));
        const EdgePoint atCorner{corners.atStart ? F{} : length, F{}, corners.atStart ? start : end, corners.incident};
        const EdgePoint first = choose(corner, atCorner, lower);

        const F radii = radius + incidentRadius;
        const F firstSeparation = corner ? corners.size - radii : first.above - radii;
        const F secondSeparation = cutHigh.above - radii;
        const M one = !corner, many = !single;
        const M in0 = firstSeparation <= margin, near1 = secondSeparation <= margin;
        const M in1 = both(both(one, many), near1);
        const M moveUp = both(M(!in0), in1);  // the first is too far, and the second takes its place
        touch.count = (in0 ? whole(1) : I{}) + (in1 ? whole(1) : I{});

        const F along = corner ? corners.gapAlong / corners.size : F{};
        const F above = corner ? corners.gapAbove / corners.size : all(1);
        touch.normalX = tangentX * along + normalX * above;
        touch.normalY = tangentY * along + normalY * above;
        const auto place = [&](const EdgePoint& point, F separation, M atCornerOnly) {
            const F fromEdge = point.above - incidentRadius - separation * 0.5f,
                    fromCorner = radius + separation * 0.5f;
            const F x = startX + tangentX * point.along, y = startY + tangentY * point.along;
            return
                typename TouchingEdges<W>::Point{atCornerOnly ? x + touch.normalX * fromCorner : x + normalX * fromEdge,
                                                 atCornerOnly ? y + touch.normalY * fromCorner : y + normalY * fromEdge,
                                                 separation, point.reference, point.incident};
        };
        const EdgePoint named = choose(moveUp, cutHigh, first);
        touch.points[0] = place(named, moveUp ? secondSeparation : firstSeparation, corner);
        touch.points[1] = place(cutHigh, secondSeparation, M{});
        return touch;
    }
};

}  // namespace plumb
