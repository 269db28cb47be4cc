// SPDX-License-Identifier: MIT
// How does the computer play?
#pragma once
#include <memory>

#include <games/frame/game.h>

namespace plumb::games::maze {

std::unique_ptr<Player> computerPlayer();

}  // namespace plumb::games::maze
