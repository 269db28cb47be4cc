// SPDX-License-Identifier: MIT
// How must a mortar be aimed to hit a place, over hills, through wind and drag?
#pragma once
#include <vector>

#include <games/artillery/aim.h>
#include <games/artillery/terrain.h>

namespace plumb::games::artillery {

struct FireTask {
    Vec2 gunner{0, 0};  ///< centre of the gunner who fires [m]
    Vec2 target{0, 0};  ///< [m]
    double wind = 0;    ///< [m/s]
};

struct FireSolution {
    Aim aim;               ///< rounded to steps that can be set
    double time = 0;       ///< of flight [s]
    double clearance = 0;  ///< least height above the ground along the path, without its two ends [m]
};

/// Tries charges in steps, from the least one that clears the hills (aimSlowestOver finds it, without drag). For each
/// charge, aimThroughLinearDrag gives the low and the high arc in closed form. The result has the arcs that clear the
/// ground. Objects on the ground are ignored: a forecast finds them. The muzzle moves with the barrel, so each arc is
/// aimed four times, each time from the last muzzle. Empty: the target is out of reach.
std::vector<FireSolution> fireSolutions(const FireTask& task, const Terrain& terrain);

}  // namespace plumb::games::artillery
