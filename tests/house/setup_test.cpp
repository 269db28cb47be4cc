// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <string>

#include "catch.h"
#include "house/repository.h"
#include "house/shell.h"

using namespace plumb::test;
namespace fs = std::filesystem;

namespace {

void writeCommand(const fs::path& file, const std::string& script) {
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(file, fs::perms::owner_all);
}

/// What install.sh says it installs on a machine that has no package yet. Nothing is installed: the commands that it
/// asks are stand-ins.
std::string installedFor(const std::string& sections) {
    const fs::path folder = fs::temp_directory_path() / "setup";
    fs::remove_all(folder);
    fs::create_directories(folder / "bin");
    fs::create_directories(folder / ".setup");
    for (const std::string file : {"install.sh", "packages.txt"})
        fs::copy_file(repository / ".setup" / file, folder / ".setup" / file);
    writeCommand(folder / "bin/dpkg-query", "exit 1");
    writeCommand(folder / "bin/apt-get", "exit 0");
    writeCommand(folder / "bin/apt-cache", "echo offered");
    writeCommand(folder / "bin/sudo", "exec \"$@\"");
    const Ran ran = shell("PATH=" + quoted((folder / "bin").string()) + ":\"$PATH\" bash " +
                          quoted((folder / ".setup/install.sh").string()) + " " + sections + " 2>&1");
    INFO(ran.output);
    REQUIRE(ran.ok);
    return ran.output;
}

bool names(const std::string& output, const std::string& package) {
    return output.find(" " + package + " ") != std::string::npos;
}

}  // namespace

TEST_CASE("a command installs what its own part needs, and the kit's packages", "[house]") {
    const std::string compare = installedFor("kit compare");
    for (const std::string package : {"g++", "libeigen3-dev", "libbox2d-dev", "libjs-dygraphs"})
        CHECK(names(compare, package));
    for (const std::string package : {"libsdl2-dev", "fonts-inter", "catch2", "clang", "chromium"})
        CHECK_FALSE(names(compare, package));

    const std::string games = installedFor("kit games");
    for (const std::string package : {"g++", "libsdl2-dev", "libcairo2-dev", "libcli11-dev"})
        CHECK(names(games, package));
    for (const std::string package : {"libbox2d-dev", "libjs-dygraphs", "catch2", "clang"})
        CHECK_FALSE(names(games, package));

    CHECK_FALSE(names(installedFor("kit"), "libfmt-dev"));
    CHECK(names(installedFor("kit tests"), "catch2"));
}
