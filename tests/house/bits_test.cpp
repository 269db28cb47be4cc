// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include <compare/engine/plumb_movers.h>
#include <compare/engine/plumb_world.h>
#include <compare/scene/builtin.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "house/bits_build.h"
#include "house/shell.h"

using namespace plumb::test;

namespace {

namespace fs = std::filesystem;

std::size_t countOf(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string hashFrom(const fs::path& program) {
    const Ran ran = shell(quoted(program.string()));
    REQUIRE(ran.ok);
    return ran.output;
}
std::string hashFrom(const std::string& compiler, const std::string& optimisation) {
    return hashFrom(buildBits(compiler, optimisation) / "bits");
}

/// As the program of tests/bits prints it.
std::string hashLineOf(const plumb::compare::Scene& scene) {
    plumb::compare::PlumbWorld made = plumb::compare::plumbWorld(scene);
    plumb::compare::PlumbMovers movers(scene, made);
    for (int tick = 0; tick < stepCount(scene); ++tick) {
        movers.step(made.world, scene.dt);
        made.world.step(scene.dt);
    }
    std::ostringstream line;
    line << "scene " << scene.name << ' ' << std::hex << std::setw(16) << std::setfill('0')
         << plumb::stateHash(made.world);
    return line.str();
}

/// 8 and 16 for the objects of sources that are compiled for so many lanes, by name; 0 for others.
int lanesOf(const std::string& object) {
    if (object.find("lanes_8_") != std::string::npos) return 8;
    return object.find("lanes_16_") != std::string::npos ? 16 : 0;
}

/// Does a name hold a template's argument for so many lanes: "f<8>(...)", "S<8, true>::g()"?
bool isOver(int lanes, const std::string& name) {
    const std::string number = std::to_string(lanes);
    return name.find("<" + number + ">") != std::string::npos || name.find("<" + number + ",") != std::string::npos;
}

struct WeakSymbols {
    int objects = 0;                          ///< that are compiled for more lanes than all machines have
    std::vector<std::string> misplaced = {};  ///< that they share with others
};

/// nm prints "member.o:" and then lines of address, letter and name; W, V and u are for what the linker merges.
WeakSymbols weakSymbolsOf(const fs::path& archive) {
    const Ran ran = shell("nm -C --defined-only " + quoted(archive.string()));
    REQUIRE(ran.ok);
    WeakSymbols found;
    int lanes = 0;
    std::istringstream lines(ran.output);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.back() == ':') {
            lanes = lanesOf(line);
            found.objects += lanes > 0 ? 1 : 0;
            continue;
        }
        const std::size_t letter = line.find(' ') + 1;
        if (lanes == 0 || letter == 0 || letter + 2 > line.size()) continue;
        const bool weak = std::string("WVuwv").find(line[letter]) != std::string::npos;
        const std::string name = line.substr(letter + 2);
        if (weak && !isOver(lanes, name)) found.misplaced.push_back(std::to_string(lanes) + " lanes: " + name);
    }
    return found;
}

}  // namespace

TEST_CASE("GCC at -O1 and -O3 and Clang at -O1, on 1, 4, 8 and 16 lanes, come to one state hash", "[house][build]") {
    const std::string reference = hashFrom("g++", "-O1");
    INFO(reference);
    const std::size_t scenes = plumb::compare::builtinScenes().size();
    REQUIRE(countOf("\n", reference) == 8 + scenes);
    REQUIRE(countOf("\nscene ", reference) == scenes);
    CHECK(countOf("lanes", reference) == 0);
    CHECK(hashFrom(PLUMB_BITS_PROGRAM) == reference);  // of this build: GCC at -O3, where it is the preset release
    CHECK(hashFrom("clang++", "-O1") == reference);
    // And the kit as it is built here, each part with the flags that it has by itself.
    for (const plumb::compare::Scene& scene : plumb::compare::builtinScenes())
        CHECK(countOf("\n" + hashLineOf(scene) + "\n", reference) == 1);
}

// The linker keeps one of all that have a name: were it the one with wide instructions, every machine would run it.
TEST_CASE("objects for 8 and 16 lanes share no inline code with the rest of the kit", "[house][build]") {
    const fs::path inBuild = fs::path("kit") / "libplumb.a", below = "plumb" / inBuild;
    for (const fs::path& archive :
         {fs::path(PLUMB_BUILD_DIR) / inBuild, buildBits("g++", "-O1") / below, buildBits("clang++", "-O1") / below}) {
        const WeakSymbols found = weakSymbolsOf(archive);
        CHECK(found.objects == 2);  // one of each width: its sources are compiled as one
        for (const std::string& name : found.misplaced) FAIL_CHECK(archive.string() << ", " << name);
    }
}
