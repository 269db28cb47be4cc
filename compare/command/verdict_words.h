// SPDX-License-Identifier: MIT
// In which words does the terminal give verdicts?
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// The text in a colour of colours.h, or as it is.
std::string painted(const std::string& text, const char* code, bool colour);

/// Four letters, which begin a line: PASS, FAIL, or ---- for what was not judged.
std::string verdictWord(Verdict verdict, bool colour);

/// "2 scenes hold, 0 fail.", and where there are any ", 1 not judged" before the full stop.
std::string countText(const std::string& what, std::span<const Verdict> verdicts, bool colour);

/// Why nothing was judged: "this scene has no checks", or that none of its checks binds the engines that were run.
std::string notJudgedText(const std::string& what, std::size_t checks);

}  // namespace plumb::compare
