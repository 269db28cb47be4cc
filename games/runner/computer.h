// SPDX-License-Identifier: MIT
// How does the computer play?
#pragma once
#include <memory>

#include <games/frame/game.h>

namespace plumb::games::runner {

std::unique_ptr<Player> computer(const GameSetup& setup);

}  // namespace plumb::games::runner
