// SPDX-License-Identifier: MIT
// When, between two frames, did two things begin to overlap? Found by bisection.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include <plumb/collide/sweep.h>

namespace plumb {

/// Bounds of the time of a collision, as fractions of the frame.
struct CollisionTime {
    double apart = 0;                 ///< they do not overlap yet here, unless they do at 0 [-]
    double overlapping = 0;           ///< they overlap here [-]
    double error = 0;                 ///< overlapping - apart = 2^-n after n probes [-]
    std::vector<double> probes = {};  ///< the fractions that were tested, in order: 0.5 and so on [-]
};

/// The lecture's time of collision (slide 24): the objects are apart at 0, in the frame before, and overlap at 1, in
/// the frame that was just drawn. The middle of the remaining interval is tested: if they overlap there, the collision
/// began before it, otherwise after it. Each probe halves the error: n probes leave 2^-n of the frame, exactly.
/// Empty when there is no overlap at 1: an object that has passed right through (tunnelled), or touched and separated,
/// is not found, so in one frame an object must move no farther than the two are thick. If the overlap begins several
/// times, one of the beginnings is found. If they overlap at 0, both bounds are 0 and nothing is probed. firstTouch
/// (sweep.h) has no such limits. Throws std::invalid_argument unless probes is 0 to 52, the number of bits of a double.
/// Source: bisection.
/// Test: "the lecture's five probes are 0.5, 0.25, 0.375, 0.4375 and 0.40625"
std::optional<CollisionTime> bisectCollision(const std::function<bool(double fraction)>& overlapping, int probes = 5);

/// The same for two shapes that move through the frame, tested by overlap(). Throws std::invalid_argument on the shapes
/// and sweeps that firstTouch refuses.
/// Test: "halving n times is within 2^-n of the first touch, 100,000 times"
std::optional<CollisionTime> bisectCollision(const Shape& a, const Sweep& sweepA, const Shape& b, const Sweep& sweepB,
                                             int probes = 5);

}  // namespace plumb
