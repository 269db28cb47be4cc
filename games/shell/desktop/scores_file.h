// SPDX-License-Identifier: MIT
// Which were the best scores of the last times?
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace plumb::games {

/// Where SDL lets a user's programs keep things; empty where it does not.
std::string scoresFileOf(const std::string& game);

/// One a line; what is no number is left out. None if there is no such file.
std::vector<std::int64_t> readScores(const std::string& file);
/// A file that cannot be written is no reason to end a game.
void writeScores(const std::string& file, const std::vector<std::int64_t>& scores);

}  // namespace plumb::games
