// SPDX-License-Identifier: MIT
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "house/arrows.h"
#include "house/repository.h"

using namespace plumb::test;

namespace {

/// The types whose values nobody sets by themselves: numbers and the enumerations of these texts.
std::set<std::string> plainTypesIn(const std::vector<std::string>& headers) {
    std::set<std::string> types{"bool", "char", "double", "float", "int", "std::size_t", "std::ptrdiff_t"};
    for (const std::string bits : {"8", "16", "32", "64"})
        for (const std::string sign : {"", "u"}) types.insert("std::" + sign + "int" + bits + "_t");
    static const std::regex enumeration(R"(\benum class (\w+))");
    for (const std::string& header : headers)
        for (std::sregex_iterator each(header.begin(), header.end(), enumeration), end; each != end; ++each)
            types.insert((*each)[1]);
    return types;
}

/// Members of structs that have no value of their own: "Shot: double speed".
std::vector<std::string> unsetMembers(const std::string& header, const std::set<std::string>& plainTypes) {
    static const std::regex structure(R"(^(?:template.*)?struct (?:alignas\(\d+\) )?(\w+)(?: final)? \{$)");
    static const std::regex member(R"(^    (?:const )?([\w:]+(?:<.*>)?[ *]+)((?:\w+, )*\w+);)");
    std::vector<std::string> unset;
    std::string owner;
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, structure)) owner = match[1];
        if (line.starts_with("}")) owner.clear();
        if (owner.empty() || !std::regex_search(line, match, member)) continue;
        std::string type = match[1];
        const bool isPointer = type.find('*') != std::string::npos;
        type.erase(type.find_last_not_of(" *") + 1);
        static const std::regex array(R"(^std::array<([\w:]+), )");
        std::smatch element;
        const bool isArray = std::regex_search(type, element, array);
        if (isPointer || plainTypes.contains(isArray ? element[1].str() : type))
            unset.push_back(owner + ": " + type + " " + match[2].str());
    }
    return unset;
}

}  // namespace

TEST_CASE("every member of every public struct has a value before anybody sets it", "[house]") {
    std::vector<std::string> headers;
    for (const auto& file : repositoryFiles()) {
        const std::string path = file.generic_string();
        if (path.starts_with("kit/") && isInstalled(path.substr(sizeof("kit/") - 1)))
            headers.push_back(textOf(repository / file));
    }
    REQUIRE(headers.size() > 100);
    const std::set<std::string> plainTypes = plainTypesIn(headers);
    for (const std::string& header : headers) CHECK(unsetMembers(header, plainTypes) == std::vector<std::string>{});
}

TEST_CASE("a planted member without a value is found", "[house]") {
    const std::string header =
        "enum class Way { Up };\nstruct A {\n    double x, y;\n    int n = 0;\n    Way way;\n    const char* name;\n"
        "    std::array<int, 3> list;\n    Vec2 at;\n    void f(int n);\n};\nclass B {\n    int hidden;\n};\n";
    CHECK(unsetMembers(header, plainTypesIn({header})) ==
          std::vector<std::string>{"A: double x, y", "A: Way way", "A: char name", "A: std::array<int, 3> list"});
}
