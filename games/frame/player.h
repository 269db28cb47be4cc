// SPDX-License-Identifier: MIT
// Who plays a game, if no one does with a keyboard?
#pragma once
#include <games/frame/action.h>

namespace plumb::games {

class Game;

/// The computer. The same games seen in the same order give the same buttons.
class Player {
public:
    virtual ~Player() = default;
    /// Of the game's next tick, bit i for action i of GameInfo.actions. The game is one that the player's own GameInfo
    /// made, so it may be cast to what it is.
    virtual Buttons decide(const Game& game) = 0;
};

}  // namespace plumb::games
