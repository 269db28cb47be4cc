# SPDX-License-Identifier: MIT
# Writes a source file with all levels into the build folder, and again whenever a level was edited.
file(GLOB levels CONFIGURE_DEPENDS "${folder}/levels/*.txt")
list(SORT levels)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${levels})
set(entries "")
foreach(level IN LISTS levels)
    file(READ "${level}" text)
    get_filename_component(file "${level}" NAME)
    string(APPEND entries "        {\"${file}\",\n         R\"level(${text})level\"},\n")
endforeach()
set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}_levels.cpp")
file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
#include <games/runner/levels.h>

namespace plumb::games::runner {

const std::vector<LevelText>& builtInLevels() {
    static const std::vector<LevelText> levels{
@entries@    };
    return levels;
}

}  // namespace plumb::games::runner
]])
target_sources(games_${name} PRIVATE "${source}")
