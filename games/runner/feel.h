// SPDX-License-Identifier: MIT
// How does the hero move?
#pragma once
#include <string>

#include <plumb/movers/platform_profile.h>

namespace plumb::games::runner {

/// A profile of the kit, with what this game adds to both: crates are pushed and pressed down.
struct Feel {
    PlatformProfile profile;
    double tick = 1.0 / 60;  ///< of the world, at each of the game's [s]
};

/// "1985", the tables as they were, or "modern": as fast and as high, with coyote time, a jump that is remembered,
/// corners that give way and an apex that hangs. Throws std::invalid_argument on another name.
Feel feelOf(const std::string& name);

/// The speed at which one must be launched to rise so high [m, m/s].
double speedToRise(const PlatformProfile& profile, double height);

}  // namespace plumb::games::runner
