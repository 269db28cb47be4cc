// SPDX-License-Identifier: MIT
// How do the position and the speed of a character change in a tick?
#pragma once
#include <plumb/movers/platform_profile.h>

namespace plumb::detail {

/// The change in one tick.
struct TickMotion {
    double shift = 0;  ///< displacement [m]
    double speed = 0;  ///< after it [m/s]
};

struct HorizontalTick {
    double speed = 0;  ///< before the tick, to the right [m/s]
    double move = 0;   ///< input, -1 to 1 [-]
    bool runs = false;
    bool onFloor = false;
    std::optional<double> most = std::nullopt;  ///< speed limit [m/s]
};
TickMotion horizontalTick(const PlatformProfile& profile, const HorizontalTick& tick, double dt);

struct VerticalTick {
    double speed = 0;  ///< before the tick, upward [m/s]
    JumpBand band;
    bool rises = false;   ///< with jump held; otherwise as after releasing it
    bool held = false;    ///< jump is held
    double holdLeft = 0;  ///< of the hold phase [s]
};
TickMotion verticalTick(const PlatformProfile& profile, const VerticalTick& tick, double dt);

}  // namespace plumb::detail
