// SPDX-License-Identifier: MIT
// In which colours does the terminal say what holds and what fails?
#pragma once

namespace plumb::compare {

// ECMA-48, "select graphic rendition".
inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* yellow = "33";

}  // namespace plumb::compare
