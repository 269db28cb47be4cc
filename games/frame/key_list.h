// SPDX-License-Identifier: MIT
// Which keys do what, as the title says it?
#pragma once
#include <string>
#include <vector>

#include <games/frame/action.h>

namespace plumb::games {

/// In lines of up to so many letters: "← → or A D  walk     ·     Space  jump". Actions that are about the same stand
/// together, where the first of them is; those about nothing, or without keys, are left out.
std::vector<std::string> keyLines(const std::vector<Action>& actions, std::size_t longest);

}  // namespace plumb::games
