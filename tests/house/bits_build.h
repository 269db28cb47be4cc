// SPDX-License-Identifier: MIT
// What does another compiler make of the same sources?
#pragma once
#include <filesystem>
#include <string>

namespace plumb::test {

/// Builds tests/bits, "clang++" "-O1"; that one has the games' programs as well, in plumb/bin. Returns the folder.
std::filesystem::path buildBits(const std::string& compiler, const std::string& optimisation);

}  // namespace plumb::test
