// SPDX-License-Identifier: MIT
// Which headers have a name of the standard library?
#pragma once
#include <map>
#include <string>
#include <vector>

namespace plumb::test {

/// Of a name, without "std::", the headers of which any has it.
using StandardNames = std::map<std::string, std::vector<std::string>>;

/// Of the names that are most in use.
const StandardNames& standardNames();

}  // namespace plumb::test
