// SPDX-License-Identifier: MIT
// Which known name was probably meant?
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace plumb::compare {

/// The known name that takes the fewest insertions, deletions and replacements of letters to reach from name; the
/// first of equals, empty when none is known.
std::string nearest(std::string_view name, std::span<const std::string> known);

/// "a, b, c", and "..." for what comes after the twelfth.
std::string listText(std::span<const std::string> known);

}  // namespace plumb::compare
