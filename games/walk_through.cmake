# SPDX-License-Identifier: MIT
# Builds the example game of README.md for the tests, as the page has it. Its name is the name in the page's line for
# list.txt. Its source is the first block of C++ on the page. Its namespace and its targets are called walk_through, so
# that a game with the page's name can be added beside it, as the page says.
set(page "${CMAKE_CURRENT_SOURCE_DIR}/README.md")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${page}" main.cpp.in)
file(READ "${page}" text)
if(NOT text MATCHES "`games/list.txt`:\n\n```\n([a-z][a-z0-9_]*): ")
    message(FATAL_ERROR "${page} has no line for games/list.txt")
endif()
set(name "${CMAKE_MATCH_1}")

string(FIND "${text}" "```cpp\n" begin)
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${text}" ${begin} -1 text)
string(FIND "${text}" "```" end)
string(SUBSTRING "${text}" 0 ${end} text)
string(REPLACE "plumb::games::${name}" "plumb::games::walk_through" text "${text}")
file(CONFIGURE OUTPUT "walk_through/${name}.cpp" CONTENT "${text}" @ONLY NEWLINE_STYLE UNIX)
add_library(games_walk_through STATIC "${CMAKE_CURRENT_BINARY_DIR}/walk_through/${name}.cpp")
plumb_warnings(games_walk_through)
plumb_precompile(games_walk_through <Eigen/Core>)
target_link_libraries(games_walk_through PUBLIC games_frame)

file(READ main.cpp.in text)
string(REPLACE "plumb::games::@name@" "plumb::games::walk_through" text "${text}")
file(CONFIGURE OUTPUT walk_through/main.cpp CONTENT "${text}" @ONLY NEWLINE_STYLE UNIX)
add_executable(plumb-walk-through "${CMAKE_CURRENT_BINARY_DIR}/walk_through/main.cpp")
plumb_warnings(plumb-walk-through)
target_link_libraries(plumb-walk-through PRIVATE games_walk_through games_shell)
