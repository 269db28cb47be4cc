// SPDX-License-Identifier: MIT
// Which games are there?
#pragma once
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

/// The games of games/list.txt in that order, each with its name.
std::vector<GameInfo> allGames();

}  // namespace plumb::games
