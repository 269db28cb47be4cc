// SPDX-License-Identifier: MIT
// How do the two bodies of each lane stand to each other?
#pragma once
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct RelativeLanes {
    using F = typename Wide<W>::Float;
    F apartX, apartY;  ///< from A's centre of mass to B's, in the world [m]
    F dx, dy;          ///< the same in A's frame
    F cos, sin;        ///< of B's angle less A's
    F cosA, sinA;
    F shiftX, shiftY;  ///< how far B comes against A in this step, in the world [m]
    F turn;            ///< and how far turning of both may take a point in addition [m]
};

/// b - a of numbers in two parts, to the last bit but one: what moves along together stays as far apart, and is not
/// pushed about by rounding. The error of the high parts' difference is kept.
/// Source: Knuth, TAOCP 2, 4.2.2, theorem B.
template <class F>
[[gnu::always_inline]] inline F difference(F highB, F lowB, F highA, F lowA) {
    const F d = highB - highA;
    const F part = d - highB;
    const F error = (highB - (d - part)) - (highA + part);
    return d + (error + (lowB - lowA));
}

/// apartX, apartY: how far apart they are, where that is not what their places say, as around a world that wraps [m].
template <int W>
[[gnu::always_inline]] inline RelativeLanes<W> relativeLanes(const std::uint32_t* a, const std::uint32_t* b,
                                                             const BodyPlace* places, const float* apartX = nullptr,
                                                             const float* apartY = nullptr) {
    using F = typename Wide<W>::Float;
    const float* rows = &places->highX;
    const Rows<W> placeA = loadRows<W, 16>(rows, a), placeB = loadRows<W, 16>(rows, b);
    const Rows<W> angleA = loadRows<W, 16>(rows + 4, a), angleB = loadRows<W, 16>(rows + 4, b);
    const Rows<W> reachA = loadRows<W, 16>(rows + 8, a), reachB = loadRows<W, 16>(rows + 8, b);
    RelativeLanes<W> r;
    r.apartX = difference(placeB.x, placeB.z, placeA.x, placeA.z);
    r.apartY = difference(placeB.y, placeB.w, placeA.y, placeA.w);
    if (apartX != nullptr) {
        r.apartX = loadLanes<W>(apartX);
        r.apartY = loadLanes<W>(apartY);
    }
    const F c = angleA.x, s = angleA.y;
    r.dx = c * r.apartX + s * r.apartY;
    r.dy = c * r.apartY - s * r.apartX;
    r.cos = c * angleB.x + s * angleB.y;
    r.sin = c * angleB.y - s * angleB.x;
    r.cosA = c;
    r.sinA = s;
    r.shiftX = reachB.x - reachA.x;
    r.shiftY = reachB.y - reachA.y;
    r.turn = reachA.z + reachB.z;
    return r;
}

}  // namespace plumb
