// SPDX-License-Identifier: MIT
// How does a hunter move in the house, where there are no lanes?
#pragma once
#include <games/maze/layout.h>
#include <games/maze/targets.h>
#include <plumb/movers/grid_pattern.h>

namespace plumb::games::maze {

/// Where a hunter waits. The chaser and the ambusher have the same home.
Pixel homeOf(Who who);
/// The point before the door, in the middle of the lane.
Pixel doorstep();

/// Moves pixel by pixel, and counts the frames of its speed pattern itself.
class HouseWalk {
public:
    HouseWalk(Who who, const Pixel& at) : who_(who), at_(at) {}

    void bob(SpeedPattern speed);    ///< up and down at home
    bool leave(SpeedPattern speed);  ///< sideways to the middle, then up; true: it is on the doorstep
    bool enter(SpeedPattern speed);  ///< down, then sideways to its home; true: it is there

    const Pixel& at() const { return at_; }
    std::uint32_t frame() const { return frame_; }
    Direction looks() const { return looks_; }

private:
    void stepTo(const Pixel& place, bool firstAcross);
    bool walkTo(const Pixel& place, bool firstAcross, SpeedPattern speed);

    Who who_;
    Pixel at_;
    Direction looks_ = Direction::Down;
    std::uint32_t frame_ = 0;
};

}  // namespace plumb::games::maze
