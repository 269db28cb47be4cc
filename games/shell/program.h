// SPDX-License-Identifier: MIT
// What does a game's program do?
#pragma once
#include <games/frame/game.h>

namespace plumb::games {

/// Its exit status: 0, or 2 on bad arguments, a broken record or whatever else the game throws, with one line on
/// standard error.
int play(const GameInfo& info, int argc, char** argv);

}  // namespace plumb::games
