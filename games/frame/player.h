// SPDX-License-Identifier: MIT
// How does the computer play a game?
#pragma once
#include <games/frame/action.h>

namespace plumb::games {

class Game;

/// The computer as a player. The same games, seen in the same order, give the same buttons.
class Player {
public:
    virtual ~Player() = default;
    /// The buttons of the game's next tick: bit i for action i of GameInfo.actions. The game was made by the GameInfo
    /// that made the player, so it may be cast to its own class.
    virtual Buttons decide(const Game& game) = 0;
};

}  // namespace plumb::games
