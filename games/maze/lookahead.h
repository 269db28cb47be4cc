// SPDX-License-Identifier: MIT
// Which direction is best for the player in the next seconds?
#pragma once
#include <games/maze/chase.h>

namespace plumb::games::maze {

/// How much each event is worth, compared with the others. A dot must be worth more than the longest way to the next
/// dot costs. Otherwise the player would never eat the last dot but one.
struct LookaheadSettings {
    int frames = 140;  ///< how far to look ahead
    double dot = 150;
    double power = 60;    ///< for the power dot, and the same again for each hunter near
    double hunter = 800;  ///< for each one caught
    double fruit = 500;
    double way = 2;          ///< cost of each tile from the last cell to the nearest dot
    double nearness = 200;   ///< cost of each dangerous hunter at the end, divided by 1 + its distance [tiles]
    double caught = 50'000;  ///< cost of being caught; a little less if it happens later
};

/// Plays copies of the chase along every way, from crossing to crossing. The hunters follow the real rules, but their
/// random numbers differ from those of the real chase.
class Lookahead {
public:
    explicit Lookahead(const LookaheadSettings& settings = {}) : settings_(settings) {}

    /// The best first direction; none only if the player's cell has no exit.
    std::optional<Direction> best(const Chase& chase) const;

private:
    double follow(Chase chase, Direction wanted, int frame) const;
    double branch(const Chase& chase, int frame) const;
    double gain(const Chase& chase, int frame) const;
    double prospects(const Chase& chase) const;

    LookaheadSettings settings_;
};

}  // namespace plumb::games::maze
