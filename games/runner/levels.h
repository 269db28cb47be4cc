// SPDX-License-Identifier: MIT
// Which levels come with the game?
#pragma once
#include <string_view>
#include <vector>

namespace plumb::games::runner {

struct LevelText {
    std::string_view file;
    std::string_view text;
};

/// The files of the folder levels, sorted by name, as they were when the program was built; levels.cmake embeds them.
const std::vector<LevelText>& builtInLevels();

}  // namespace plumb::games::runner
