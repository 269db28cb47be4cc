// SPDX-License-Identifier: MIT
// Which contacts rest, so that their normals and arms stay as they are?
//
// Two rigid faces that lie on each other, and carry load at both points, cannot turn against each other. What their
// bodies turn is the compliance of the contact's springs. If the loads of a column followed that, it would buckle. So
// while a face rests on a face, the directions and the arms of its forces stay as they were, until an arm is wrong by
// mostArm; then all are taken anew. The moment of a force F about a body's centre is wrong by at most mostArm k F (k
// radius of gyration).
// ../../rest.md lists which columns stand by this.
// Test: "a column of forty boxes that are kept awake stands for a minute"
// Source of the idea: contact recycling in Box2D 3.2, which allows a motion of 5 cm.
#pragma once
#include <plumb/dynamics/contacts/lanes/point_kinematics.h>

namespace plumb {

/// A resting contact keeps its arms until one is wrong by more than this share of the body's radius of gyration [-]: 12
/// mm for a box of 1 m.
inline constexpr float mostArm = 0.03f;
/// A contact sticks if its friction impulse is less than this share of mu times its normal impulse [-]. Near 1, but not
/// 1: both are sums over a step, and rounding must not take what slides for what sticks.
inline constexpr float mostGrip = 0.99f;

/// Does a face rest on a face: did each point carry load and stick in the last step, and has it kept its arms? Reads
/// what the last step has left in the batch. same: a point is the successor of the point with the same number.
template <int W, class M>
M rests(const ContactBatch& batch, int lane, const LaneArms<W> (&now)[2], const M (&same)[2]) {
    using F = typename Wide<W>::Float;
    using I = typename Wide<W>::Int;
    const I yes = I{} + 1;
    const F friction = loadLanes<W>(batch.friction + lane);
    I moves{};
    for (int i = 0; i < 2; ++i) {
        const PointLanes& p = batch.points[i];
        const F load = loadLanes<W>(p.totalNormal + lane), held = magnitude(loadLanes<W>(p.totalTangent + lane));
        const M far = now[i].changeFrom(LaneArms<W>::of(p, lane)) > F{} + mostArm;
        const M empty = load <= F{}, slides = held > mostGrip * friction * load;
        moves |= (far ? yes : I{}) | (empty ? yes : I{}) | (slides ? yes : I{}) | (same[i] ? I{} : yes);
    }
    return moves == I{};
}

}  // namespace plumb
