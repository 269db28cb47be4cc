// SPDX-License-Identifier: MIT
// Where are Plumb's own files, and what is in one?
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace plumb::test {

inline const std::filesystem::path repository = PLUMB_SOURCE_DIR;

inline std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// As seen from the repository's folder, sorted; without what git ignores, or, where there is no git, without build/.
std::vector<std::filesystem::path> repositoryFiles();

struct SourceFile {
    std::string path;  ///< as it is included: "plumb/shapes/mass.h", "compare/scene/scene.h"
    std::string text;
};

/// The C++ files under a folder, their paths as seen from root; none where there is no such folder.
inline std::vector<SourceFile> sourcesUnder(const std::filesystem::path& folder, const std::filesystem::path& root) {
    std::vector<SourceFile> sources;
    if (!std::filesystem::exists(folder)) return sources;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            sources.push_back({std::filesystem::relative(entry.path(), root).generic_string(), textOf(entry.path())});
    return sources;
}

/// The names of all tests of some sources, as they are written there.
std::vector<std::string> testNamesIn(const std::vector<SourceFile>& sources);

}  // namespace plumb::test
