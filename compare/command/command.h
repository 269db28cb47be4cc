// SPDX-License-Identifier: MIT
// What does plumb-compare do when it is called?
#pragma once
#include <iosfwd>
#include <span>
#include <string>

namespace plumb::compare {

inline constexpr int noneFails = 0;   ///< exit status: every check that was judged holds
inline constexpr int checkFails = 1;  ///< exit status: a check fails
inline constexpr int badInput = 2;    ///< exit status: bad usage or input; one line on err says what and where

/// The command of compare/README.md: args without the program's name. colour: out understands ANSI colours.
int runCommand(std::span<const std::string> args, std::ostream& out, std::ostream& err, bool colour = false);

}  // namespace plumb::compare
