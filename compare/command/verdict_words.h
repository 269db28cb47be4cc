// SPDX-License-Identifier: MIT
// Which words and colours are used for verdicts in the terminal?
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <compare/check/verdict.h>

namespace plumb::compare {

// ECMA-48, "select graphic rendition".
inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* grey = "90";  // "bright black" of most terminals, beyond the standard

/// The text in one of these colours; unchanged if colour is false.
std::string painted(const std::string& text, const char* code, bool colour);

/// Four characters at the start of a line: PASS, FAIL, or ---- if nothing was judged.
std::string verdictWord(Verdict verdict, bool colour);

/// "2 scenes hold, 0 fail."; if some were not judged, with ", 1 not judged" before the full stop.
std::string countText(const std::string& what, std::span<const Verdict> verdicts, bool colour);

/// Why nothing was judged: "this scene has no checks", or none of its checks applies to the engines that were run.
std::string notJudgedText(const std::string& what, std::size_t checks);

}  // namespace plumb::compare
