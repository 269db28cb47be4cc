// SPDX-License-Identifier: MIT
// What does a game's program do?
#pragma once
#include <games/frame/game.h>

namespace plumb::games {

/// Runs the program and returns its exit status: 0, or 2 on bad arguments, a broken record or any other exception, with
/// one line on standard error.
int play(const GameInfo& info, int argc, char** argv);

}  // namespace plumb::games
