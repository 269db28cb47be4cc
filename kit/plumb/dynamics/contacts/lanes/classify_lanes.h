// SPDX-License-Identifier: MIT
// Which of W pairs can meet in this step, and of which must be computed exactly how they do?
#pragma once
#include <plumb/dynamics/bodies/relative_lanes.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

/// How far each pair may move relative to each other in the step, in any direction, plus the contact margin [m].
template <int W>
typename Wide<W>::Float marginOf(const RelativeLanes<W>& r) {
    return squareRoot<W>(r.shiftX * r.shiftX + r.shiftY * r.shiftY) + r.turn + contactMargin;
}

template <int W>
struct Reaching {
    typename Wide<W>::Int count, uncertain;  ///< as in FreshLanes
    typename Wide<W>::Mask far;              ///< apart by more than the contact margin

    /// How far to move a point that is half-way between two surfaces along the normal from A to B [m]. Of a distant
    /// pair it is wanted where the two will meet, on A's surface.
    typename Wide<W>::Float shiftToPlace(typename Wide<W>::Float separation) const {
        return far ? separation * -0.5f : typename Wide<W>::Float{};
    }
};

/// For pairs with this normal in A's frame, separation and number of points. One that cannot meet along its normal in
/// this step gets no points. If it slides and turns in the step by less than this length, within which the same faces
/// stay opposite each other, its present manifold is right; otherwise a distant pair is uncertain.
template <int W>
Reaching<W> reachOf(const RelativeLanes<W>& r, typename Wide<W>::Float normalX, typename Wide<W>::Float normalY,
                    typename Wide<W>::Float separation, typename Wide<W>::Int count, typename Wide<W>::Float length) {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    using M = typename Wide<W>::Mask;
    const F worldX = r.cosA * normalX - r.sinA * normalY, worldY = r.sinA * normalX + r.cosA * normalY;
    const F closing = r.turn - (r.shiftX * worldX + r.shiftY * worldY);
    const F sliding = magnitude(r.shiftY * worldX - r.shiftX * worldY);
    const M far = separation > F{} + contactMargin, open = separation > closing;
    const M never = both(far, open);
    const M stays = sliding + r.turn < length, straight = r.turn * 10.0f < length;
    const M sure = both(stays, straight);
    const I there = never ? I{} : count;
    const I closer = sure ? I{} : I{} + 1;
    const I uncertain = far ? closer : I{};
    return {there, there > I{} ? uncertain : I{}, far};
}

}  // namespace plumb
