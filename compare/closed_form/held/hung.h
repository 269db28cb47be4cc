// SPDX-License-Identifier: MIT
// How does a body hang from what stays?
#pragma once
#include <string>

#include <compare/closed_form/held/holding.h>

namespace plumb::compare {

struct Hung {
    HeldBody body{};
    Vec2 pivot{0, 0};       ///< about which its origin goes [m]
    double length = 0;      ///< from there to its origin [m]
    double equivalent = 0;  ///< L = I_pivot / (m l) [m]
    double gravity = 0;     ///< downward [m/s^2]
    double angle = 0;       ///< from straight down, at the start [rad]
    bool turns = false;     ///< with the angle: on a hinge; on rods it does not
};

/// By a hinge, or by a rod and those beside it. Throws Unsupported where something else holds it too.
Hung hungOf(const Scene& scene, const std::string& body, const std::string& joint);

}  // namespace plumb::compare
