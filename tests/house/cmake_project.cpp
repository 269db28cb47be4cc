// SPDX-License-Identifier: MIT
#include "house/cmake_project.h"

#include <algorithm>
#include <thread>

#include "house/shell.h"

namespace plumb::test {

void buildProject(const CmakeProject& project) {
    const std::string cmake = quoted(PLUMB_CMAKE);
    const std::string build = quoted(project.build.string());
    std::string configure =
        cmake + " -S " + quoted(project.source.string()) + " -B " + build + " -G " + quoted(PLUMB_GENERATOR);
    for (const std::string& option : project.options) configure += " " + quoted(option);
    mustRun(configure);
    mustRun(cmake + " --build " + build + " --parallel " +
            std::to_string(std::max(1u, std::thread::hardware_concurrency())));
}

std::filesystem::path houseFolder(const std::string& name) {
    return std::filesystem::path(PLUMB_BUILD_DIR) / "house" / name;
}

}  // namespace plumb::test
