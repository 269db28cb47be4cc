// SPDX-License-Identifier: MIT
// Which games are there?
#pragma once
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

/// As games/list.txt has them, each with its name.
std::vector<GameInfo> allGames();

}  // namespace plumb::games
