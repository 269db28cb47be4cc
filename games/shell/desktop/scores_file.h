// SPDX-License-Identifier: MIT
// How are the best scores kept from one run of a program to the next?
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace plumb::games {

/// A file in the folder that SDL gives for a user's data; empty if SDL gives none.
std::string scoresFileOf(const std::string& game);

/// One score per line; lines that are not numbers are skipped. Empty if there is no such file.
std::vector<std::int64_t> readScores(const std::string& file);
/// Does nothing if the file cannot be written: that is no reason to end a game.
void writeScores(const std::string& file, const std::vector<std::int64_t>& scores);

}  // namespace plumb::games
