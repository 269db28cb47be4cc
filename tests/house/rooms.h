// SPDX-License-Identifier: MIT
// Which units does the kit consist of, and in which rooms of dynamics do they lie? A unit is a header with the source
// of its name.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "house/arrows.h"
#include "house/repository.h"

namespace plumb::test {

/// The ranks as the table headed "| rank | rooms |" says: in each row, every word in backticks that is a room or a
/// unit. A word that ends in a slash is a folder; another is a unit of the folder of dynamics itself.
Ranks roomRanksIn(std::string_view readme);

/// "bodies/" of "plumb/dynamics/bodies/body_store.h"; of what lies in dynamics itself, "values" if it has a rank, else
/// "world". Empty of anything else.
std::string roomOf(std::string_view path, const Ranks& ranks);

// Each finds one sentence a fault, none where all is well.

/// A room includes itself and lower ranks only, and is in the table.
std::vector<std::string> upwardRooms(const Ranks& ranks, const std::vector<SourceFile>& kit);
/// No unit includes another that includes it, over any number of others. Names all units that do.
std::vector<std::string> unitsInRings(const std::vector<SourceFile>& kit);
/// Only what is named may have functions that take the whole state of a world.
std::vector<std::string> takersOfWholeWorlds(const std::set<std::string>& allowed, const Ranks& ranks,
                                             const std::vector<SourceFile>& kit);
/// No more files in a folder, lines in a file and lines in a function than these.
struct Sizes {
    std::size_t files = 32, fileLines = 400, functionLines = 50;
};
std::vector<std::string> tooLarge(const Sizes& most, const std::vector<SourceFile>& sources);

}  // namespace plumb::test
