// SPDX-License-Identifier: MIT
// Tests of one folder are compiled together. Where two of them have helpers of one name the compiler may refuse them,
// or take the wrong one without a word.
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "house/repository.h"

using namespace plumb::test;

namespace {

/// Of the types, functions and values that start a line in a source's unnamed namespaces.
std::set<std::string> unnamedNames(const std::string& text) {
    static const std::regex type(R"(^(?:struct|class|enum class|enum|union) (\w+).*)");
    static const std::regex other(R"(^[A-Za-z_][\w:<>,&* ]*?[ &*>](\w+)(?:\(|\{| = |;|\[).*)");
    static const std::regex none(R"(^(?:using|template|namespace|static_assert|TEST_CASE)\b.*)");
    std::set<std::string> names;
    bool inside = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line == "namespace {") inside = true;
        if (line == "}  // namespace") inside = false;
        std::smatch match;
        if (inside && !std::regex_match(line, none) &&
            (std::regex_match(line, match, type) || std::regex_match(line, match, other)))
            names.insert(match[1]);
    }
    return names;
}

/// One sentence a name that two sources of one folder have.
std::vector<std::string> twins(const std::vector<SourceFile>& sources) {
    std::map<std::string, std::set<std::string>> owners;
    for (const auto& [path, text] : sources) {
        if (!path.ends_with(".cpp")) continue;
        const std::string folder = path.substr(0, path.rfind('/') + 1);
        for (const std::string& name : unnamedNames(text)) owners[folder + ": " + name].insert(path);
    }
    std::vector<std::string> found;
    for (const auto& [name, paths] : owners)
        if (paths.size() > 1) found.push_back(name + " is in " + *paths.begin() + " and in " + *paths.rbegin());
    return found;
}

}  // namespace

TEST_CASE("no two tests of a folder have one name for two helpers", "[house]") {
    const std::vector<SourceFile> tests = sourcesUnder(repository / "tests", repository);
    REQUIRE(tests.size() > 1);
    CHECK(twins(tests) == std::vector<std::string>{});
}

TEST_CASE("planted helpers of one name are caught, whatever they are", "[house]") {
    const auto source = [](const std::string& path, const std::string& lines) {
        return SourceFile{path, "namespace {\n\n" + lines + "\n}  // namespace\n"};
    };
    const auto twinsOf = [&](const std::string& one, const std::string& other) {
        return twins({source("tests/a/one.cpp", one), source("tests/a/other.cpp", other)});
    };
    CHECK(twinsOf("constexpr double rounding = 1e-15;", "constexpr double rounding = 1e-14;  // more") ==
          std::vector<std::string>{"tests/a/: rounding is in tests/a/one.cpp and in tests/a/other.cpp"});
    CHECK(twinsOf("void run(World& world, double seconds) {\n}", "void run(World& world, int ticks) {\n}").size() == 1);
    CHECK(twinsOf("struct Worst {\n};", "class Worst : public Base {\n};").size() == 1);
    CHECK(twinsOf("const std::vector<Shape> shapes{1};", "template <class T>\nstd::vector<T>& shapes() {\n}").size() ==
          1);
    CHECK(twinsOf("void run() {\n    const int ticks = 1;\n}", "int ticks = 1;").empty());
    CHECK(twins({source("tests/a/one.cpp", "int ticks;"), source("tests/b/other.cpp", "int ticks;")}).empty());
    CHECK(twins({source("tests/a/one.h", "int ticks;"), source("tests/a/one.cpp", "int ticks;")}).empty());
}
