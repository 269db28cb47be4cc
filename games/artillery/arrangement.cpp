// SPDX-License-Identifier: MIT
#include <games/artillery/arrangement.h>

namespace plumb::games::artillery {
namespace {

constexpr double leastUpright = 580, leastWithChart = 660;  ///< height of the window [units of the screen]
constexpr double wideTop = 78, wideBottom = 64;             ///< what the displays cover [units of the screen]
constexpr double uprightTop = 164, uprightBottom = 106;     ///< without the small picture [units of the screen]

}  // namespace

Arrangement arrangementIn(const Aabb& screen) {
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
