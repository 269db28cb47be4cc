// SPDX-License-Identifier: MIT
// How does the hero move?
#pragma once
#include <string>

#include <plumb/movers/platform_profile.h>

namespace plumb::games::runner {

/// A profile of the kit. This game adds to each profile that the hero pushes crates and presses them down.
struct Feel {
    PlatformProfile profile;
    double tick = 1.0 / 60;  ///< time that the world advances per tick of the game [s]
};

/// "1985": the original tables. "modern": about the same speeds and heights, with coyote time, jump buffering, corner
/// correction and a longer apex. Throws std::invalid_argument on any other name.
Feel feelOf(const std::string& name);

/// The launch speed [m/s] that gives a rise of this height [m].
double speedToRise(const PlatformProfile& profile, double height);

}  // namespace plumb::games::runner
