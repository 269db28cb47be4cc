// SPDX-License-Identifier: MIT
// Where are Plumb's own files, and what is in one?
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace plumb::test {

inline const std::filesystem::path repository = PLUMB_SOURCE_DIR;

inline std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace plumb::test
