// SPDX-License-Identifier: MIT
// How must a mortar be aimed to hit a place, over hills, through wind and drag?
#pragma once
#include <vector>

#include <games/artillery/aim.h>
#include <games/artillery/terrain.h>

namespace plumb::games::artillery {

struct FireTask {
    Vec2 gunner{0, 0};  ///< the middle of who fires [m]
    Vec2 target{0, 0};  ///< [m]
    double wind = 0;    ///< [m/s]
};

struct FireSolution {
    Aim aim;               ///< rounded to what can be set
    double time = 0;       ///< of flight [s]
    double clearance = 0;  ///< the least height above the ground on the way, without its two ends [m]
};

/// For charges from the least that gets over the hills, in steps: the low arc and the high, by their closed forms
/// (aimSlowestOver without drag says where to begin, aimThroughLinearDrag aims), those that pass over the ground. What
/// stands on it is not looked at: a forecast tells. The muzzle moves with the barrel, so it is aimed four times, each
/// from where the last had it. None: the target is out of reach.
std::vector<FireSolution> fireSolutions(const FireTask& task, const Terrain& terrain);

}  // namespace plumb::games::artillery
