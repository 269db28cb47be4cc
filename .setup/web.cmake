# SPDX-License-Identifier: MIT
# Emscripten's own toolchain file, found beside em++ wherever that is installed.
find_program(PLUMB_EMXX em++ NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(REAL_PATH "${PLUMB_EMXX}" emxx)
get_filename_component(emscripten "${emxx}" DIRECTORY)
# Eigen is nothing but headers: the machine's own will do.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
include("${emscripten}/cmake/Modules/Platform/Emscripten.cmake")
