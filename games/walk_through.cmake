# SPDX-License-Identifier: MIT
# The game that README.md walks through, built as it stands there: the first block of C++ on the page.
set(page "${CMAKE_CURRENT_SOURCE_DIR}/README.md")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${page}")
file(READ "${page}" text)
string(FIND "${text}" "```cpp\n" begin)
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${text}" ${begin} -1 text)
string(FIND "${text}" "```" end)
string(SUBSTRING "${text}" 0 ${end} text)
file(CONFIGURE OUTPUT walk_through/bounce/bounce.cpp CONTENT "${text}" @ONLY NEWLINE_STYLE UNIX)
plumb_add_game(bounce "${CMAKE_CURRENT_BINARY_DIR}/walk_through/bounce")
