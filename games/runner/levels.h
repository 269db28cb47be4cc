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

/// Those of the folder levels, by their files' names, as they were when the program was built: levels.cmake puts them
/// in.
const std::vector<LevelText>& builtInLevels();

}  // namespace plumb::games::runner
