// SPDX-License-Identifier: MIT
// Which way promises most in the seconds to come?
#pragma once
#include <games/maze/chase.h>

namespace plumb::games::maze {

/// What is worth how much, against each other. A dot must be worth more than the longest way to the next one, or the
/// last but one would never be eaten.
struct LookaheadSettings {
    int frames = 140;  ///< so far ahead
    double dot = 150;
    double power = 60;    ///< for itself, and as much again for each hunter near
    double hunter = 800;  ///< caught
    double fruit = 500;
    double way = 2;          ///< off, for each tile between the end and the nearest dot
    double nearness = 200;   ///< off, divided by the tiles to each hunter at the end
    double caught = 50'000;  ///< off, whenever; a little less the later
};

/// Plays copies of the chase down every way, from crossing to crossing, by the rules that the hunters keep. It does not
/// know what chance will be. The best first direction; none only when there is nowhere to go.
class Lookahead {
public:
    explicit Lookahead(const LookaheadSettings& settings = {}) : settings_(settings) {}

    std::optional<Direction> best(const Chase& chase) const;

private:
    double follow(Chase chase, Direction wanted, int frame) const;
    double branch(const Chase& chase, int frame) const;
    double gain(const Chase& chase, int frame) const;
    double prospects(const Chase& chase) const;

    LookaheadSettings settings_;
};

}  // namespace plumb::games::maze
