// SPDX-License-Identifier: MIT
// What does the report look like before it has data?
#pragma once
#include <string_view>

namespace plumb::compare {

/// The place for the data; it is in the page once.
inline constexpr std::string_view pageDataMark = "@@data@@";

/// page/page.html with its style, its scripts and the chart library. The definition is generated when the program is
/// built (page/embed.cmake).
std::string_view page();

}  // namespace plumb::compare
