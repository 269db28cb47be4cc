// SPDX-License-Identifier: MIT
#include "house/bits_build.h"

#include "house/cmake_project.h"

namespace plumb::test {

std::filesystem::path buildBits(const std::string& compiler, const std::string& optimisation) {
    const std::filesystem::path folder = houseFolder("bits") / (compiler + optimisation);
    const bool games = compiler == "clang++" && optimisation == "-O1";
    // All this is compiled twice.
    buildProject({.source = std::string(PLUMB_SOURCE_DIR) + "/tests/bits",
                  .build = folder,
                  .options = {"-DCMAKE_CXX_COMPILER=" + compiler, "-DCMAKE_BUILD_TYPE=Release",
                              "-DCMAKE_CXX_FLAGS_RELEASE=" + optimisation + " -DNDEBUG", "-DPLUMB_OPTIMISE=OFF",
                              std::string("-DPLUMB_BUILD_GAMES=") + (games ? "ON" : "OFF")}});
    return folder;
}

}  // namespace plumb::test
