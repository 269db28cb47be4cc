// SPDX-License-Identifier: MIT
// What does each letter of a level's text stand for?
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include <games/runner/level.h>

namespace plumb::games::runner {

inline constexpr char startLetter = 'S';
inline constexpr char platformLetter = 'p';
inline constexpr std::string_view trackLetters = "-|+";

struct Letter {
    char letter;
    std::string_view about;
    Tile tile{};                                    ///< empty for a thing
    std::optional<ThingKind> thing = std::nullopt;  ///< empty for a tile
};

/// All letters except the start, platforms and their tracks.
const std::vector<Letter>& legend();

/// nullptr when the legend does not have this letter.
const Letter* find(char letter);

/// Every letter that a map may contain, as error messages list them.
std::string allLetters();

}  // namespace plumb::games::runner
