// SPDX-License-Identifier: MIT
// What does the report look like before it has anything to show?
#pragma once
#include <string_view>

namespace plumb::compare {

/// Where the data go; stands in the page once.
inline constexpr std::string_view pageDataMark = "@@data@@";

/// page/page.html with its style, its scripts and the chart library in it. The definition is made when the program is
/// built (page/embed.cmake).
std::string_view page();

}  // namespace plumb::compare
