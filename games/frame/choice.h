// SPDX-License-Identifier: MIT
// Which values do a game's options have, and which can they have?
#pragma once
#include <map>
#include <string>
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

/// Those of GameInfo, but for the values given. Throws std::invalid_argument on an option that the game has not, or a
/// value that is none of its choices.
std::map<std::string, std::string> optionsOf(const GameInfo& info, const std::map<std::string, std::string>& given);

/// The options that stand in the title, in their order: those with choices, but for what only the command line has.
std::vector<Option> optionsToChoose(const GameInfo& info);

/// The choice so many steps behind another, round and round.
const std::string& choiceBehind(const Option& option, const std::string& now, int steps);

}  // namespace plumb::games
