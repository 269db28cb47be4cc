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
inline Arrangement arrangementIn(const Aabb& screen) {
    constexpr double leastUpright = 580, leastWithChart = 660;  ///< height of the window [units of the screen]
    constexpr double wideTop = 78, wideBottom = 64;             ///< what the displays cover [units of the screen]
    constexpr double uprightTop = 164, uprightBottom = 106;     ///< without the small picture [units of the screen]
    const double height = screen.upper.y() - screen.lower.y();
    Arrangement arrangement{.upright = height >= leastUpright, .screen = screen, .field = screen};
    if (!arrangement.upright) {
        arrangement.field.lower = {screen.lower.x(), wideTop};
        arrangement.field.upper = {screen.upper.x(), screenHeight - wideBottom};
        return arrangement;
    }
    arrangement.hasChart = height >= leastWithChart;
    arrangement.chartTop = screen.lower.y() + uprightTop;
    const double top = arrangement.chartTop + (arrangement.hasChart ? chartHeight + 8 : 0);
    arrangement.field.lower = {screen.lower.x(), top};
    arrangement.field.upper = {screen.upper.x(), screen.upper.y() - uprightBottom};
    return arrangement;
}

}  // namespace plumb::games::artillery
