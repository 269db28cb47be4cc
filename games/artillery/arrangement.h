// SPDX-License-Identifier: MIT
// Where are the displays of a battle: over the edges of a wide picture, or above and below the field of an upright one?
#pragma once
#include <games/frame/camera.h>

namespace plumb::games::artillery {

struct Arrangement {
    bool upright = false;
    Aabb screen;            ///< the visible part [units of the screen]
    Aabb field;             ///< the part of it that no display covers [units of the screen]
    bool hasChart = false;  ///< is there room for a small picture of the whole island?
    double chartTop = 0;    ///< of that picture [units of the screen]
};

inline constexpr double chartHeight = 108;  ///< [units of the screen]

/// screen: the visible part, in units of the screen.
Arrangement arrangementIn(const Aabb& screen);

}  // namespace plumb::games::artillery
