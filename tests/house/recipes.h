// SPDX-License-Identifier: MIT
// Which commands does a page tell its reader to run?
#pragma once
#include <string>
#include <vector>

namespace plumb::test {

/// Those in its blocks ```sh, in their order: one a line, for bash, from the root of the checkout, each in a shell of
/// its own. Without comments and blank lines; a line that ends in \ goes on in the next. Other blocks hold no commands.
std::vector<std::string> recipesOn(const std::string& page);

}  // namespace plumb::test
