// SPDX-License-Identifier: MIT
// Which game is played in the page? The build writes the source for each game (game_of_page.cpp.in).
#pragma once
#include <games/frame/game.h>

namespace plumb::games {

GameInfo gameOfPage();

}  // namespace plumb::games
