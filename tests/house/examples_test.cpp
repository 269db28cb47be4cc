// SPDX-License-Identifier: MIT
#include "house/examples.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <utility>

#include "catch.h"
#include "house/cmake_project.h"
#include "house/repository.h"
#include "house/shell.h"

using namespace plumb::test;
namespace fs = std::filesystem;

namespace {

/// Those of every page, by names that can be a file's: "README" of the README, "kit_plumb_dynamics_joints" of
/// kit/plumb/dynamics/joints.md.
std::map<std::string, std::vector<Example>> allExamples() {
    std::map<std::string, std::vector<Example>> examples{{"README", examplesOn(textOf(repository / "README.md"))}};
    for (const auto& entry : fs::recursive_directory_iterator(repository / "kit")) {
        if (entry.path().extension() != ".md") continue;
        std::string name = fs::relative(entry.path(), repository).replace_extension().generic_string();
        std::replace(name.begin(), name.end(), '/', '_');
        examples[name] = examplesOn(textOf(entry.path()));
    }
    return examples;
}

/// Each by the page's name and its number there.
std::map<std::string, Example> examplesByName() {
    std::map<std::string, Example> byName;
    for (const auto& [page, examples] : allExamples())
        for (std::size_t i = 0; i < examples.size(); ++i) byName[page + "_" + std::to_string(i)] = examples[i];
    return byName;
}

/// Builds programs as a user does who has installed the kit. Returns the folder in which they are, by their names.
fs::path buildExamples(const std::map<std::string, Example>& programs) {
    const fs::path folder = houseFolder("examples"), sources = folder / "sources";
    fs::remove_all(folder / "prefix");
    fs::remove_all(sources);
    fs::create_directories(sources);
    const std::string prefix = (folder / "prefix").string();
    mustRun(quoted(PLUMB_CMAKE) + " --install " + quoted(PLUMB_BUILD_DIR) + " --prefix " + quoted(prefix));
    for (const auto& [name, example] : programs) std::ofstream(sources / (name + ".cpp")) << example.program;
    buildProject({.source = repository / "tests/examples",
                  .build = folder / "build",
                  .options = {std::string("-DCMAKE_CXX_COMPILER=") + PLUMB_COMPILER, "-DCMAKE_BUILD_TYPE=Release",
                              "-DCMAKE_PREFIX_PATH=" + prefix, "-DEXAMPLES=" + sources.string()}});
    return folder / "build";
}

/// What the kit's page says of the ten lines, and of the same with a joint [KB].
std::pair<double, double> sizesOnPage() {
    static const std::regex sizes(R"(ten lines have (\d+) KB of code, and (\d+) KB once)");
    const std::string page = textOf(repository / "kit/README.md");
    std::smatch match;
    REQUIRE(std::regex_search(page, match, sizes));
    return {std::stod(match[1]), std::stod(match[2])};
}

/// Code, tables and constants, by the second line that `size` prints.
double kilobytesOf(const fs::path& program) {
    const Ran ran = shell("size " + quoted(program.string()) + " | tail -n 1");
    REQUIRE(ran.ok);
    return std::stod(ran.output) / 1000;
}

}  // namespace

TEST_CASE("a page's programs are found, with what they print", "[house]") {
    const std::string page =
        "# A\n\n```cpp\nint part();\n```\n\n```cpp\nint main() {}\n```\n\n```text\n1 2\n```\nand\n"
        "```cpp\nint main() { return 1; }\n```\nwords\n```text\nnot its own\n```\n";
    const std::vector<Example> examples = examplesOn(page);
    REQUIRE(examples.size() == 2);
    CHECK(examples[0].program == "int main() {}\n");
    CHECK(examples[0].output == "1 2\n");
    CHECK(examples[1].output.empty());
}

TEST_CASE("every module of the kit has a page with a program, and the README leads to it", "[house]") {
    const std::string readme = textOf(repository / "README.md");
    CHECK_FALSE(examplesOn(readme).empty());
    for (const auto& entry : fs::directory_iterator(repository / "kit/plumb")) {
        if (!entry.is_directory()) continue;
        const std::string module = entry.path().filename().string();
        CAPTURE(module);
        CHECK_FALSE(examplesOn(textOf(entry.path() / "README.md")).empty());
        CHECK(readme.find("(kit/plumb/" + module + "/README.md)") != std::string::npos);
    }
}

TEST_CASE("every program on a page of the kit is followed by what it prints", "[house]") {
    for (const auto& [page, examples] : allExamples()) {
        CAPTURE(page);
        if (page == "README") continue;
        for (const Example& example : examples) CHECK_FALSE(example.output.empty());
    }
}

TEST_CASE("every program on a page compiles, and prints what the page says", "[house][build]") {
    const std::map<std::string, Example> examples = examplesByName();
    const fs::path programs = buildExamples(examples);
    for (const auto& [name, example] : examples) {
        CAPTURE(name);
        const Ran ran = shell(quoted((programs / name).string()));
        CHECK(ran.ok);
        if (!example.output.empty()) CHECK(ran.output == example.output);
    }
}

TEST_CASE("a program without joints has no code of joints in it, and one that locks a body has", "[house][build]") {
    std::map<std::string, Example> programs = examplesByName();
    std::erase_if(programs, [](const auto& each) { return each.first != "README_0"; });
    REQUIRE(programs.size() == 1);
    Example locked = programs.at("README_0");
    const std::size_t at = locked.program.find(".position = ");
    REQUIRE(at != std::string::npos);
    locked.program.insert(locked.program.find("}, ", at) + 3, ".lockX = true, ");
    programs["locked"] = locked;
    const fs::path folder = buildExamples(programs);
    const auto hasJoints = [&](const std::string& program) {
        const Ran names = shell("nm -C " + quoted((folder / program).string()));
        REQUIRE(names.ok);
        return names.output.find("plumb::JointBatch::solve(") != std::string::npos;
    };
    CHECK_FALSE(hasJoints("README_0"));
    CHECK(hasJoints("locked"));
    const auto [plain, withJoints] = sizesOnPage();
    CHECK_THAT(plain, Catch::Matchers::WithinRel(kilobytesOf(folder / "README_0"), 0.05));
    CHECK_THAT(withJoints, Catch::Matchers::WithinRel(kilobytesOf(folder / "locked"), 0.05));
    CHECK(shell(quoted((folder / "locked").string())).output == shell(quoted((folder / "README_0").string())).output);
}
