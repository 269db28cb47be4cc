// SPDX-License-Identifier: MIT
// The page of limits: does each constant have the value that stands there, and does each test exist?
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "house/repository.h"

using namespace plumb::test;

namespace {

/// A row of a table: "| **64** corners (`maxPolygonVertices`, `shape.h`) | ... | "name of a test" |".
struct LimitRow {
    std::string line, number, name, file;
    std::optional<std::string> test;  ///< its beginning; none in a table without tests
};

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(cell);
    if (!cells.empty()) cells.erase(cells.begin());
    return cells;
}

/// A row that cannot be read has no name.
LimitRow limitRowOf(const std::string& line) {
    static const std::regex limit(R"(^ \*\*([0-9][0-9.,^e+-]*?)(?: [^*]*)?\*\*.*\(`([\w.]+)`, `([\w.]+)`\).*$)");
    static const std::regex named("^ \"([^\"]+)\" $");
    const std::vector<std::string> cells = cellsOf(line);
    LimitRow row{line, {}, {}, {}, {}};
    std::smatch match;
    if (cells.size() != 2 && cells.size() != 4) return row;
    if (!std::regex_match(cells.front(), match, limit)) return row;
    const std::string number = match[1], name = match[2], file = match[3];
    if (cells.size() == 4 && !std::regex_match(cells.back(), match, named)) return row;
    row = {line, number, name, file, {}};
    if (cells.size() == 4) row.test = match[1];
    return row;
}

/// All rows of all tables but their heads.
std::vector<LimitRow> limitRowsOn(const std::string& page) {
    std::vector<LimitRow> rows;
    std::istringstream lines(page);
    bool isHead = true;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) isHead = true;
        if (!isHead && line.starts_with("|")) rows.push_back(limitRowOf(line));
        if (line.starts_with("|---")) isHead = false;
    }
    return rows;
}

/// "4,000", "20'000", "1e15", "0.3f", "2^24" or "1 << 24".
std::optional<double> numberOf(std::string text) {
    std::erase_if(text, [](char c) { return c == ',' || c == '\'' || c == ' ' || c == '\n'; });
    for (const std::string power : {"2^", "1<<"})
        if (text.starts_with(power)) {
            const std::optional<double> exponent = numberOf(text.substr(power.size()));
            return exponent ? std::optional(std::exp2(*exponent)) : std::nullopt;
        }
    if (text.ends_with('f') || text.ends_with('F')) text.pop_back();
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The values that a source gives to a name: of constants, members' defaults, and the bounds of members and arguments.
std::vector<double> valuesOf(const std::string& name, const std::string& source) {
    std::string escaped = std::regex_replace(name, std::regex(R"(\.)"), R"(\.)");
    const std::string value = R"(([^,;(){}]+))";
    std::vector<double> values;
    const auto add = [&](const std::string& pattern) {
        const std::regex expression(pattern);
        for (std::sregex_iterator each(source.begin(), source.end(), expression), end; each != end; ++each)
            for (std::size_t i = 1; i < each->size(); ++i)
                if (const std::optional<double> number = numberOf((*each)[i])) values.push_back(*number);
    };
    add(R"(\bconstexpr (?:[\w:]+ |[^;{}()]*, ))" + escaped + R"( = )" + value + "[,;]");
    add(R"(\n    (?:int|double|float) )" + escaped + R"( =\s+)" + value + ";");
    add("\"" + escaped + R"(", "[^"]*", Allowed::within\()" + value + ", " + value + R"(\))");
    add(R"(\brequireWithin\()" + escaped + ", " + value + ", " + value + ",");
    return values;
}

std::string fileNameOf(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

/// What is wrong with a constant on the page; empty if nothing is.
std::string faultOfConstant(const LimitRow& row, const std::vector<SourceFile>& kit) {
    bool hasFile = false;
    std::vector<double> values;
    for (const SourceFile& source : kit) {
        if (fileNameOf(source.path) != row.file) continue;
        hasFile = true;
        for (const double value : valuesOf(row.name, source.text)) values.push_back(value);
    }
    if (!hasFile) return "there is no file " + row.file;
    if (values.empty()) return row.file + " has no number " + row.name;
    const std::optional<double> number = numberOf(row.number);
    const bool isThere = number && std::find(values.begin(), values.end(), *number) != values.end();
    return isThere ? "" : row.name + " in " + row.file + " is not " + row.number;
}

std::string faultOfTest(const std::string& beginning, const std::vector<std::string>& names) {
    const auto count =
        std::count_if(names.begin(), names.end(), [&](const std::string& name) { return name.starts_with(beginning); });
    if (count == 1) return "";
    return (count == 0 ? "no test begins with: " : "several tests begin with: ") + beginning;
}

/// One sentence for each row that is not true.
std::vector<std::string> faultsOn(const std::string& page, const std::vector<SourceFile>& kit,
                                  const std::vector<std::string>& testNames) {
    std::vector<std::string> faults;
    for (const LimitRow& row : limitRowsOn(page)) {
        const std::string constant = row.name.empty() ? "cannot be read: " + row.line : faultOfConstant(row, kit);
        if (!constant.empty()) faults.push_back(constant);
        const std::string test = row.test ? faultOfTest(*row.test, testNames) : "";
        if (!test.empty()) faults.push_back(test);
    }
    return faults;
}

/// Constants of the dynamics whose names say that they are limits, and that are not on the page: "mostDepths in
/// wall_search.cpp".
std::vector<std::string> missingOn(const std::string& page, const std::vector<SourceFile>& kit) {
    std::set<std::pair<std::string, std::string>> listed;
    for (const LimitRow& row : limitRowsOn(page)) listed.emplace(row.name, row.file);
    static const std::regex constants(R"(\bconstexpr [^;{}()]*;)");
    static const std::regex limit(R"(\b((?:most|farthest)[A-Z]\w*|farthest|longest|largest|shortest\w*) = ([^,;]+))");
    std::vector<std::string> missing;
    for (const SourceFile& source : kit) {
        if (!source.path.starts_with("plumb/dynamics/")) continue;
        const std::string& text = source.text;
        for (std::sregex_iterator each(text.begin(), text.end(), constants), end; each != end; ++each) {
            const std::string statement = (*each)[0];
            for (std::sregex_iterator name(statement.begin(), statement.end(), limit); name != end; ++name) {
                const std::pair key((*name)[1].str(), fileNameOf(source.path));
                if (numberOf((*name)[2]) && !listed.contains(key)) missing.push_back(key.first + " in " + key.second);
            }
        }
    }
    return missing;
}

const std::filesystem::path kitFolder = repository / "kit";

std::string limitsPage() {
    return textOf(kitFolder / "plumb/dynamics/limits.md");
}

}  // namespace

TEST_CASE("each limit on the page of limits has its value in the kit, and a test of its name", "[house]") {
    const std::vector<SourceFile> kit = sourcesUnder(kitFolder / "plumb", kitFolder);
    const std::vector<std::string> testNames = testNamesIn(sourcesUnder(repository / "tests", repository));
    const std::vector<LimitRow> rows = limitRowsOn(limitsPage());
    CHECK(std::count_if(rows.begin(), rows.end(), [](const LimitRow& row) { return row.test.has_value(); }) > 30);
    CHECK(faultsOn(limitsPage(), kit, testNames) == std::vector<std::string>{});
}

TEST_CASE("each constant of the dynamics that is called a limit is on the page of limits", "[house]") {
    CHECK(missingOn(limitsPage(), sourcesUnder(kitFolder / "plumb", kitFolder)) == std::vector<std::string>{});
}

TEST_CASE("the page of limits is named by the pages that lead to it", "[house]") {
    CHECK(textOf(kitFolder / "plumb/dynamics/README.md").find("(limits.md)") != std::string::npos);
    CHECK(textOf(kitFolder / "README.md").find("(plumb/dynamics/limits.md)") != std::string::npos);
}

TEST_CASE("no name of a test has a semicolon, at which CTest's lists would cut it", "[house]") {
    for (const std::string& name : testNamesIn(sourcesUnder(repository / "tests", repository)))
        if (name.find(';') != std::string::npos) FAIL_CHECK(name);
}

TEST_CASE("planted faults on a page of limits are caught", "[house]") {
    const std::vector<SourceFile> kit{
        {
            "plumb/dynamics/walls/stops.cpp",
            "constexpr int mostImpacts = 24;\nconstexpr float a = 1e-3f, mostTurn = 0.3f;\n",
        },
        {"plumb/dynamics/settings.h",
         "struct S {\n    double time = 0.5;  ///< [s]\n    double rate =\n        30;\n};\n"},
        {"plumb/dynamics/describe.h", "visit({\"subSteps\", \"-\", Allowed::within(1, 64), \"x\"}, def.subSteps);\n"},
        {"plumb/shapes/tiles.h", "inline constexpr int cells = 1 << 24;\nif (mostImpacts = 7) {}\n"},
        {"plumb/shapes/mass.cpp", "    requireWithin(mass.mass, 1e-12, 1e12, field, \".mass\");\n"}};
    const std::vector<std::string> names{"a ball stays", "a ball is stopped", "a box falls"};
    const std::string head = "# Limits\n\n| limit | beyond it | why | test |\n|---|---|---|---|\n";
    const auto faults = [&](const std::string& rows) { return faultsOn(head + rows, kit, names); };
    const auto one = [](const std::string& fault) { return std::vector<std::string>{fault}; };

    CHECK(faults("| **24** impacts (`mostImpacts`, `stops.cpp`) | it stays | time | \"a ball stays\" |\n"
                 "| **0.5 s** of rest (`time`, `settings.h`) | sleeps | - | \"a box\" |\n"
                 "| **30 Hz**: of springs (`rate`, `settings.h`) | - | - | \"a box\" |\n"
                 "| **64** (`subSteps`, `describe.h`) | - | - | \"a box\" |\n"
                 "| **2^24** cells (`cells`, `tiles.h`) | - | - | \"a box\" |\n"
                 "| **1e12 kg** (`mass.mass`, `mass.cpp`) | - | - | \"a box\" |\n")
              .empty());
    CHECK(faults("| **25** (`mostImpacts`, `stops.cpp`) | - | - | \"a box\" |\n") ==
          one("mostImpacts in stops.cpp is not 25"));
    CHECK(faults("| **24** (`mostBounces`, `stops.cpp`) | - | - | \"a box\" |\n") ==
          one("stops.cpp has no number mostBounces"));
    CHECK(faults("| **24** (`mostImpacts`, `gone.cpp`) | - | - | \"a box\" |\n") == one("there is no file gone.cpp"));
    CHECK(faults("| **7** (`mostImpacts`, `tiles.h`) | - | - | \"a box\" |\n") ==
          one("tiles.h has no number mostImpacts"));
    CHECK(faults("| **24** (`mostImpacts`, `stops.cpp`) | - | - | \"a box flies\" |\n") ==
          one("no test begins with: a box flies"));
    CHECK(faults("| **24** (`mostImpacts`, `stops.cpp`) | - | - | \"a ball\" |\n") ==
          one("several tests begin with: a ball"));
    for (const std::string row : {"| 24 impacts (`mostImpacts`, `stops.cpp`) | - | - | \"a box\" |",
                                  "| **24** impacts `mostImpacts` | - | - | \"a box\" |",
                                  "| **24** (`mostImpacts`, `stops.cpp`) | - | - | a box |",
                                  "| **24** (`mostImpacts`, `stops.cpp`) | - | \"a box\" |"})
        CHECK(faults(row + "\n") == one("cannot be read: " + row));

    const std::string listed = head + "| **24** (`mostImpacts`, `stops.cpp`) | - | - | \"a box\" |\n";
    CHECK(missingOn(listed, kit) == one("mostTurn in stops.cpp"));
    CHECK(missingOn(listed + "| **0.3** (`mostTurn`, `stops.cpp`) | it |\n", kit).empty());
}
