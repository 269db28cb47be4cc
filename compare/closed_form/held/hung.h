// SPDX-License-Identifier: MIT
// How does a body hang from a body that does not move?
#pragma once
#include <string>

#include <compare/closed_form/held/holding.h>

namespace plumb::compare {

struct Hung {
    HeldBody body{};
    Vec2 pivot{0, 0};       ///< the point about which its origin swings [m]
    double length = 0;      ///< from there to its origin [m]
    double equivalent = 0;  ///< L = I_pivot / (m l) [m]
    double gravity = 0;     ///< downward [m/s^2]
    double angle = 0;       ///< from straight down, at the start [rad]
    bool turns = false;     ///< it turns with the angle: true on a hinge, false on rods
};

/// It hangs by a hinge, or by a rod and the rods parallel to it. Throws Unsupported if another joint holds it too.
Hung hungOf(const Scene& scene, const std::string& body, const std::string& joint);

}  // namespace plumb::compare
