// SPDX-License-Identifier: MIT
// Is the window upright, so that the camera comes closer and the displays are larger?
#pragma once
#include <games/frame/camera.h>

namespace plumb::games::runner {

inline constexpr double uprightBand =
    104;  ///< what the displays cover at an upright window's top [units of the screen]

/// screen: the visible part, in units of the screen.
inline bool isUpright(const Aabb& screen) {
    constexpr double least = 580;  ///< height of an upright window [units of the screen]
    return screen.upper.y() - screen.lower.y() >= least;
}

}  // namespace plumb::games::runner
