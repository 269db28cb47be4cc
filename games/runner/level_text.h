// SPDX-License-Identifier: MIT
// How is a level read from a text that a person drew?
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <games/runner/level.h>

namespace plumb::games::runner {

/// Where something stands in a text, both from 1.
struct TextPlace {
    int row = 1, column = 1;
};

/// Throws std::invalid_argument with "<file>:<row>:<column>: <complaint>".
[[noreturn]] void refuse(std::string_view file, const TextPlace& place, std::string_view complaint);

/// A head of lines "name: Dawn Meadow", "sky: dawn", "par: 60", in any order; lines that begin with ; say nothing; then
/// a line "map:" and, to the end, the rows of the map, the topmost first, by legend(). README.md tells it at length.
/// Throws as refuse() on anything else. file is for messages only.
Level readLevel(std::string_view text, std::string_view file);

}  // namespace plumb::games::runner
