// SPDX-License-Identifier: MIT
// What lies over the game: title, pause, end, best scores?
#pragma once
#include <games/frame/menu.h>
#include <games/frame/session.h>

namespace plumb::games {

struct ScreenView {
    const Session& session;
    const Menu& menu;
    std::int64_t since = 0;  ///< the screen came up [ticks]
    int rank = -1;           ///< of the last round among the best scores; -1: not among them
};

void drawScreen(Canvas& canvas, const ScreenView& view);

/// Where the menu's first line is drawn, in the units that screenPlace() scales.
Vec2 menuTop(Screen screen);

/// Screens grow in a window that is higher than the safe area: on a phone that is held upright they would be too small.
/// visible: of the screen's units.
Place screenPlace(const Aabb& visible);

}  // namespace plumb::games
