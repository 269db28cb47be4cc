// SPDX-License-Identifier: MIT
// How would a build folder's sources be compiled?
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::test {

struct CompileCommand {
    std::string file, command;

    bool has(std::string_view word) const;
    std::string optimisation() const;  ///< the last -O..., which holds; empty where there is none
};

/// Of a folder that was configured with CMAKE_EXPORT_COMPILE_COMMANDS; a test fails where there are none.
std::vector<CompileCommand> compileCommandsIn(const std::filesystem::path& build);

}  // namespace plumb::test
