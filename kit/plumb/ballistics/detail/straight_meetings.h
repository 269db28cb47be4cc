// SPDX-License-Identifier: MIT
// When can what flies straight on, at a given speed, meet what moves evenly?
#pragma once
#include <array>
#include <cstddef>

#include <plumb/ballistics/shot.h>

namespace plumb::detail {

struct StraightMeetings {
    struct Meeting {
        double time = 0;     ///< [s]
        double closing = 0;  ///< distance over time: how fast the two come together in the mean [m/s]
    };
    std::array<Meeting, 2> meetings{};  ///< the earlier first
    std::size_t count = 0;              ///< two where the target is faster, comes closer and goes off again
};

/// d target, further off than muzzle [m], w its velocity less the shooter's, v speed of the shot [m/s].
///   closing = -w . d / |d| +- S,  S^2 = v^2 - (d x w)^2 / d^2
/// A target out of reach by no more than rounding is met, once.
StraightMeetings straightMeetings(const Vec2& d, const Vec2& w, double v);

}  // namespace plumb::detail
