// SPDX-License-Identifier: MIT
// Whose turn is it, in a few words, and what is a player told who presses a button in the rival's turn?
#pragma once
#include <string>

#include <games/artillery/match.h>

namespace plumb::games::artillery {

/// Such as "Your turn", "The Tides aim" or "The Tides' shell flies". Empty when the battle is over.
std::string turnText(const Match& match);

/// The answer to a press in the rival's turn. It is shown in place of turnText() for a moment.
class Answer {
public:
    /// One tick; pressed: was a button pressed in it? Returns whether an answer begins.
    bool update(const Match& match, bool pressed);
    int ticksLeft() const { return left_; }
    /// Such as "Wait: the Tides aim".
    static std::string text(const Match& match);

private:
    int left_ = 0;  ///< [ticks]
};

}  // namespace plumb::games::artillery
