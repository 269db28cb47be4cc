// SPDX-License-Identifier: MIT
// When, between two frames, did two things begin to overlap? Found by halving.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include <plumb/collide/sweep.h>

namespace plumb {

/// What is known of the time of a collision, as fractions of the frame.
struct CollisionTime {
    double apart = 0;                 ///< they do not overlap yet, unless they did from the start [-]
    double overlapping = 0;           ///< they do [-]
    double error = 0;                 ///< overlapping - apart = 2^-n after n probes [-]
    std::vector<double> probes = {};  ///< the fractions that were asked, in order: 0.5 and so on [-]
};

/// The lecture's time of collision (slide 24): the object is apart at 0, in the frame before, and overlaps at 1, in the
/// frame that was just drawn. The middle of what is left is asked: does it overlap there, it began before, else after.
/// Each probe halves the error: n of them leave 2^-n of the frame, exactly.
/// Empty when there is no overlap at 1: what has gone right through (tunnelled), or touched and parted, is not seen, so
/// an object must be no faster than a frame's way as long as the two are thick. Of several beginnings it finds one.
/// What overlaps at 0 began no later: both bounds are 0, and nothing is probed. firstTouch (sweep.h) has no such
/// limits. Throws std::invalid_argument unless probes is 0 to 52, as many as the bits of a double. Source: bisection.
/// Test: "the lecture's five probes are 0.5, 0.25, 0.375, 0.4375 and 0.40625"
std::optional<CollisionTime> bisectCollision(const std::function<bool(double fraction)>& overlapping, int probes = 5);

/// Of two shapes on their ways through the frame, by overlap(). Throws std::invalid_argument on shapes and ways that
/// firstTouch refuses as well.
/// Test: "halving n times is within 2^-n of the first touch, 100,000 times"
std::optional<CollisionTime> bisectCollision(const Shape& a, const Way& wayA, const Shape& b, const Way& wayB,
                                             int probes = 5);

}  // namespace plumb
