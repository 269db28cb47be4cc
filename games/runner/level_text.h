// SPDX-License-Identifier: MIT
// How is a level read from a text that a person drew, or from a file?
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <games/runner/level.h>

namespace plumb::games::runner {

/// A place in a text; both numbers begin at 1.
struct TextPlace {
    int row = 1, column = 1;
};

/// Throws std::invalid_argument with "<file>:<row>:<column>: <complaint>".
[[noreturn]] void refuse(std::string_view file, const TextPlace& place, std::string_view complaint);

/// The text begins with lines such as "name: Dawn Meadow", "sky: dawn" and "par: 60", in any order. Lines that begin
/// with ; are comments. Then follow a line "map:" and the rows of the map to the end of the text, the top row first,
/// with the letters of legend(). README.md tells more. Throws as refuse() does on any other text. file: for messages
/// only.
Level readLevel(std::string_view text, std::string_view file);

/// The level of a file. Throws std::invalid_argument when the file cannot be read, and as readLevel() does. In a
/// browser there are no files.
Level levelIn(const std::string& file);

}  // namespace plumb::games::runner
