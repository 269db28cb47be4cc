// SPDX-License-Identifier: MIT
// What does plumb-compare bench do?
#pragma once
#include <iosfwd>

#include <compare/command/arguments.h>

namespace plumb::compare {

/// Measures the scenes that the arguments name in the engines they name, prints the table as it grows, and writes what
/// was asked for. Throws std::invalid_argument for scenes and files that are not, std::runtime_error when a run fails.
void runBench(const Arguments& arguments, const std::vector<Engine>& engines, std::ostream& out);

}  // namespace plumb::compare
