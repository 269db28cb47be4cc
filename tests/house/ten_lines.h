// SPDX-License-Identifier: MIT
// Does the README's ten-line program do what the README says?
#pragma once
#include <filesystem>

namespace plumb::test {

/// Runs it: it prints where its ball lies at last.
void requireBallAtRest(const std::filesystem::path& program);

}  // namespace plumb::test
