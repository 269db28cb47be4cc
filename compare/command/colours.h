// SPDX-License-Identifier: MIT
// Which colours does the terminal use for what holds, what fails, and what was not judged?
#pragma once

namespace plumb::compare {

// ECMA-48, "select graphic rendition".
inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* grey = "90";  // "bright black" of most terminals, beyond the standard

}  // namespace plumb::compare
