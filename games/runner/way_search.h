// SPDX-License-Identifier: MIT
// Which way leads to the beacon, and which buttons bring the hero nearer to it?
#pragma once
#include <vector>

#include <games/frame/action.h>
#include <games/runner/level.h>
#include <games/runner/stage.h>

namespace plumb::games::runner {

/// The length of a way through the air, around ground, thorns and water, as if the hero could fly. It guides findWay().
class WayField {
public:
    explicit WayField(const Level& level);

    double distance(const Vec2& from) const;  ///< large where there is no way [m]

private:
    double& at(Cell cell) { return distance_[index(cell)]; }
    std::size_t index(Cell cell) const { return static_cast<std::size_t>(cell.row * tiles_.columns() + cell.column); }
    bool isOpen(Cell cell) const;
    bool isOpenBetween(Cell from, Cell to) const;
    Cell inside(Cell cell) const;

    TileMap tiles_;
    std::vector<double> distance_;
};

struct SearchSettings {
    double gain = 8;           ///< the search ends at a safe place this much nearer to the beacon [m]
    int mostTicks = 2000;      ///< simulated; then the best place so far is taken if it gains leastGain
    int lastTicks = 5000;      ///< simulated otherwise; then any safe place is taken
    int stopTicks = 50;        ///< how long the hero must survive when it stops at the place found
    double ticksPerMetre = 9;  ///< cost of the remaining way; above the fastest pace, so that going on is preferred
    double hurtTicks = 200;    ///< cost of being hurt
    double leastGain = 1;      ///< least gain that is worth taking [m]
    double triedTicks = 6;     ///< cost for each move already tried from a place
    double againTicks = 40;    ///< cost for each earlier visit to a place
};

/// A best-first search that plays copies of the stage. From each place it tries a few moves (run, jump for some time,
/// wait, turn back), the likeliest first. A copy continues like the stage itself, to the last bit, so the result is
/// exact. Returns the buttons of the next ticks, at least one.
std::vector<Buttons> findWay(const Stage& stage, Buttons last, const WayField& field,
                             const SearchSettings& settings = {});

}  // namespace plumb::games::runner
