// SPDX-License-Identifier: MIT
// What does plumb-compare bench do?
#pragma once
#include <iosfwd>

#include <compare/command/arguments.h>

namespace plumb::compare {

/// Measures the scenes that the arguments name in the engines they name, prints the table row by row, and writes the
/// files that were asked for. Throws std::invalid_argument for scenes and files that do not exist, std::runtime_error
/// if a run fails.
void runBench(const Arguments& arguments, const std::vector<Engine>& engines, std::ostream& out);

}  // namespace plumb::compare
