// SPDX-License-Identifier: MIT
// Which known name was probably meant?
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace plumb::compare {

/// The known name that is reached from name with the fewest insertions, deletions and replacements of letters. If
/// several are equally near, the first; empty if no name is known.
std::string nearest(std::string_view name, std::span<const std::string> known);

/// "a, b, c", with "..." for all names after the twelfth.
std::string listText(std::span<const std::string> known);

}  // namespace plumb::compare
