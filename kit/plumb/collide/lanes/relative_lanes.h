// SPDX-License-Identifier: MIT
// What is the relative position, rotation and motion of the two bodies of each lane?
#pragma once
#include <cstdint>

#include <plumb/collide/lanes/body_place.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct RelativeLanes {
    using F = typename Wide<W>::Float;
    F apartX, apartY;  ///< from A's centre of mass to B's, in the world [m]
    F dx, dy;          ///< the same in A's frame [m]
    F cos, sin;        ///< of B's angle minus A's
    F cosA, sinA;      ///< of A's angle
    F shiftX, shiftY;  ///< predicted displacement of B relative to A in this step, in the world [m]
    F turn;            ///< upper bound on how much farther the rotations of both can move a point [m]
};

/// b - a of two numbers that are each a sum of a high and a low float, exact to the last bit but one. The rounding
/// error of the high parts' difference is computed and added. So two bodies that move together keep their distance, and
/// rounding errors do not push them.
/// Source: Knuth, TAOCP 2, 4.2.2, theorem B.
template <class F>
[[gnu::always_inline]] inline F difference(F highB, F lowB, F highA, F lowA) {
    const F d = highB - highA;
    const F part = d - highB;
    const F error = (highB - (d - part)) - (highA + part);
    return d + (error + (lowB - lowA));
}

/// apartX, apartY: if given, the distance from A to B to use instead of the difference of their places, as for periodic
/// images in a world that wraps [m].
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
