// SPDX-License-Identifier: MIT
// How are title, pause, end and best scores drawn over the game?
#pragma once
#include <string>
#include <vector>

#include <games/frame/menu.h>
#include <games/frame/session.h>

namespace plumb::games {

struct ScreenView {
    const Session& session;
    const Menu& menu;
    std::int64_t since = 0;  ///< how long the screen has been shown [ticks]
    int rank = -1;           ///< of the last round among the best scores; -1: not among them
};

void drawScreen(Canvas& canvas, const ScreenView& view);

/// The middle of the menu's first line, in the units that screenPlace() scales.
Vec2 menuTop(Screen screen);

/// Makes screens larger in a window that is higher than the safe area: on an upright phone they would be too small.
/// visible: the visible part, in units of the screen.
Place screenPlace(const Aabb& visible);

/// How the title lists the keys of a game.
/// Lines of at most this number of letters: "← → or A D  walk     ·     Space  jump". Actions with the same text in
/// about share one entry, at the place of the first of them. Actions without that text or without keys are left out.
std::vector<std::string> keyLines(const std::vector<Action>& actions, std::size_t longest);

}  // namespace plumb::games
