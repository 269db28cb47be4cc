// SPDX-License-Identifier: MIT
// How does the title list the keys of a game?
#pragma once
#include <string>
#include <vector>

#include <games/frame/action.h>

namespace plumb::games {

/// Lines of at most this number of letters: "← → or A D  walk     ·     Space  jump". Actions with the same text in
/// about share one entry, at the place of the first of them. Actions without that text or without keys are left out.
std::vector<std::string> keyLines(const std::vector<Action>& actions, std::size_t longest);

}  // namespace plumb::games
