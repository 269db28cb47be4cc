// SPDX-License-Identifier: MIT
#include "house/cmake_project.h"

#include <algorithm>
#include <thread>

#include "house/shell.h"

namespace plumb::test {

void configureProject(const CmakeProject& project) {
    std::string configure = quoted(PLUMB_CMAKE) + " -S " + quoted(project.source.string()) + " -B " +
                            quoted(project.build.string()) + " -G " + quoted(PLUMB_GENERATOR);
    for (const std::string& option : project.options) configure += " " + quoted(option);
    mustRun(configure);
}

void buildProject(const CmakeProject& project) {
    configureProject(project);
    mustRun(quoted(PLUMB_CMAKE) + " --build " + quoted(project.build.string()) + " --parallel " +
            std::to_string(std::max(1u, std::thread::hardware_concurrency())));
}

std::filesystem::path houseFolder(const std::string& name) {
    return std::filesystem::path(PLUMB_BUILD_DIR) / "house" / name;
}

}  // namespace plumb::test
