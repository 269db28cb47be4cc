// SPDX-License-Identifier: MIT
// Which buttons bring the hero on from here?
#pragma once
#include <vector>

#include <games/frame/action.h>
#include <games/runner/stage.h>
#include <games/runner/way_field.h>

namespace plumb::games::runner {

struct SearchSettings {
    double gain = 8;           ///< so much nearer to the beacon, and safe, is enough [m]
    int mostTicks = 2000;      ///< looked at; then the best found so far is taken, if it brings leastGain
    int lastTicks = 5000;      ///< looked at if it does not; then anything safe is taken
    int stopTicks = 50;        ///< it must live on for, where what was found ends, if it stops there
    double ticksPerMetre = 9;  ///< still to go: more than the fastest takes, so that it looks ahead rather than around
    double hurtTicks = 200;    ///< what it is worth not to be hurt
    double leastGain = 1;      ///< what is worth going for [m]
    double triedTicks = 6;     ///< what each move already tried from a place makes the next one there wait
    double againTicks = 40;    ///< what each earlier coming to a place makes the next one wait
};

/// Best first, over copies of the stage that are played on: a handful of moves (run, jump so long, wait, turn back)
/// from each place reached, the likeliest first. The copies go on as the stage itself will, to the last bit, so what
/// was found comes true. Gives the buttons of the coming ticks, one at least.
std::vector<Buttons> findWay(const Stage& stage, Buttons last, const WayField& field,
                             const SearchSettings& settings = {});

}  // namespace plumb::games::runner
