// SPDX-License-Identifier: MIT
// What does a tick add to the place and the speed of a character?
#pragma once
#include <plumb/movers/platform_profile.h>

namespace plumb::detail {

/// Of one tick, in metres.
struct TickMotion {
    double shift = 0;  ///< by which it goes [m]
    double speed = 0;  ///< after it [m/s]
};

struct LevelTick {
    double speed = 0;  ///< before it, to the right [m/s]
    double move = 0;   ///< wanted, -1 to 1 [-]
    bool runs = false;
    bool onFloor = false;
    std::optional<double> most = std::nullopt;  ///< speed [m/s]
};
TickMotion levelTick(const PlatformProfile& profile, const LevelTick& tick, double dt);

struct VerticalTick {
    double speed = 0;  ///< before it, up [m/s]
    JumpBand band;
    bool rises = false;  ///< with jump held; else as let go
    bool held = false;   ///< jump is
};
TickMotion verticalTick(const PlatformProfile& profile, const VerticalTick& tick, double dt);

}  // namespace plumb::detail
