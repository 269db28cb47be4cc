// SPDX-License-Identifier: MIT
// Which values do a game's options have, and which can they have?
#pragma once
#include <map>
#include <string>
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

/// The values of all options: the given ones, and the defaults of GameInfo for the others. Throws std::invalid_argument
/// on an unknown option, or on a value that is not one of the option's choices.
std::map<std::string, std::string> optionsOf(const GameInfo& info, const std::map<std::string, std::string>& given);

/// The options in the title, in their order: those with choices, except the ones that only the command line has.
std::vector<Option> optionsToChoose(const GameInfo& info);

/// The choice this number of steps after now; the first choice follows the last.
const std::string& choiceBehind(const Option& option, const std::string& now, int steps);

}  // namespace plumb::games
