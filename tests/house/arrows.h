// SPDX-License-Identifier: MIT
// Which includes go where the house's map does not let them?
#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "house/repository.h"

namespace plumb::test {

using Ranks = std::map<std::string, int>;  ///< of modules: {"math", 0}

/// The ranks as the table headed "| rank | <what> |" says: in each row, every word in backticks of its second column.
/// A word that stands in several rows has the rank of the first.
Ranks ranksOf(std::string_view readme, const std::string& what);
/// The same of the table of "modules", and only of words that are one.
Ranks ranksIn(std::string_view readme, const std::set<std::string>& modules);

/// The folder under root: "shapes" of "plumb/shapes/mass.h" under "plumb"; of a file in root itself, its name; empty of
/// anything else.
std::string folderUnder(std::string_view root, std::string_view path);
/// The folder under plumb/; empty of the umbrella header and of anything else.
std::string moduleOf(std::string_view path);

/// What is named between <> or "" in the include lines, in their order.
std::vector<std::string> includesOf(std::string_view text);

// Each finds one sentence a fault, none where all is well.

/// A folder under root includes itself and lower ranks only, and is in the table; so does a file in root itself, by its
/// name. The kit's umbrella header may include all, and nothing of the kit may include it.
std::vector<std::string> upwardArrows(const Ranks& ranks, const std::vector<SourceFile>& sources,
                                      std::string_view root = "plumb");
/// Nothing in these sources includes what is in the folder.
std::vector<std::string> arrowsInto(std::string_view folder, const std::vector<SourceFile>& sources);
/// In games/, a game includes the C++ standard library, the kit, the frame and its own folder; the frame does without
/// games and shells. The shells may include what they like, but for games.
std::vector<std::string> arrowsOutOfGames(const std::vector<SourceFile>& games);
/// The umbrella header and those that lie in a module's own folder are installed; no header in a folder below is.
bool isInstalled(std::string_view path);
/// No header that is installed includes one of the kit that is not.
std::vector<std::string> arrowsOutOfInstalled(const std::vector<SourceFile>& kit);
/// A source includes its own header first: so one that is compiled by itself proves that its header stands alone.
std::vector<std::string> ownHeadersNotFirst(const std::vector<SourceFile>& kit);

}  // namespace plumb::test
