// SPDX-License-Identifier: MIT
// Does a project outside of this build configure, compile and link?
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plumb::test {

struct CmakeProject {
    std::filesystem::path source;      ///< the folder of its CMakeLists.txt
    std::filesystem::path build;       ///< made where it is not there; what is up to date in it stays
    std::vector<std::string> options;  ///< "-DNAME=value"
};

/// A test fails, with the output, where this does.
void configureProject(const CmakeProject& project);

/// Configures and builds; likewise.
void buildProject(const CmakeProject& project);

/// A folder of this build for what a test makes.
std::filesystem::path houseFolder(const std::string& name);

}  // namespace plumb::test
