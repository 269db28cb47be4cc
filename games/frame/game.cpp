// SPDX-License-Identifier: MIT
#include <games/frame/game.h>

#include <plumb/math/check.h>

namespace plumb::games {

const std::string& GameSetup::option(const std::string& name) const {
    const auto found = options.find(name);
    if (found == options.end()) refuse("option", "this game has no option \"" + name + "\"");
    return found->second;
}

}  // namespace plumb::games
