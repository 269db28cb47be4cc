// SPDX-License-Identifier: MIT
#include "house/rooms.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace plumb::test {
namespace {

constexpr std::string_view dynamics = "plumb/dynamics/";

std::string unitOf(const std::string& path) {
    return path.substr(0, path.rfind('.'));
}

using Units = std::map<std::string, std::set<std::string>>;  ///< of each unit, those that it includes

Units unitsOf(const std::vector<SourceFile>& kit) {
    Units units;
    for (const SourceFile& source : kit) {
        std::set<std::string>& included = units[unitOf(source.path)];
        for (const std::string& include : includesOf(source.text))
            if (include.starts_with("plumb/") && unitOf(include) != unitOf(source.path))
                included.insert(unitOf(include));
    }
    return units;
}

/// Takes out the units that include none of the others, again and again: of what is left each leads into a ring.
Units withoutLeaves(Units units) {
    for (bool changed = true; changed;) {
        const std::size_t before = units.size();
        std::erase_if(units, [&](const auto& unit) {
            return std::none_of(unit.second.begin(), unit.second.end(),
                                [&](const std::string& included) { return units.contains(included); });
        });
        changed = units.size() != before;
    }
    return units;
}

Units reversed(const Units& units) {
    Units back;
    for (const auto& [unit, included] : units) {
        back[unit];
        for (const std::string& other : included)
            if (units.contains(other)) back[other].insert(unit);
    }
    return back;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Does a function's body begin with this line? Of layout as the formatter makes it.
bool opensFunction(const std::string& line) {
    static const std::regex opens(R"(^ {0,4}(?!namespace|class|struct|enum|template|union|if|for|while|switch|else|do)"
                                  R"()[^ /#].*\) ?[a-z: ]*\{$)");
    return std::regex_match(line, opens);
}

}  // namespace

Ranks roomRanksIn(std::string_view readme) {
    Ranks ranks = ranksOf(readme, "rooms");
    for (const auto& [unit, rank] : Ranks(ranks))
        if (!unit.ends_with('/') && unit != "world") ranks.try_emplace("values", rank);
    return ranks;
}

std::string roomOf(std::string_view path, const Ranks& ranks) {
    if (!path.starts_with(dynamics)) return {};
    const std::string rest(path.substr(dynamics.size()));
    if (const std::size_t slash = rest.find('/'); slash != std::string::npos) return rest.substr(0, slash + 1);
    const std::string unit = unitOf(rest);
    return unit != "world" && ranks.contains(unit) ? "values" : "world";
}

std::vector<std::string> upwardRooms(const Ranks& ranks, const std::vector<SourceFile>& kit) {
    std::set<std::string> faults;
    for (const SourceFile& source : kit) {
        const std::string from = roomOf(source.path, ranks);
        if (from.empty()) continue;
        if (!ranks.contains(from)) faults.insert("`" + from + "` has no rank");
        for (const std::string& include : includesOf(source.text)) {
            const std::string to = roomOf(include, ranks);
            if (to.empty() || to == from || !ranks.contains(to) || !ranks.contains(from)) continue;
            if (ranks.at(to) >= ranks.at(from) && unitOf(include) != unitOf(source.path))
                faults.insert(source.path + " includes " + include + ": `" + from + "` has rank " +
                              std::to_string(ranks.at(from)) + ", `" + to + "` has rank " +
                              std::to_string(ranks.at(to)));
        }
    }
    return {faults.begin(), faults.end()};
}

std::vector<std::string> unitsInRings(const std::vector<SourceFile>& kit) {
    const Units rings = withoutLeaves(reversed(withoutLeaves(unitsOf(kit))));
    std::vector<std::string> names;
    for (const auto& [unit, others] : rings) names.push_back(unit);
    return names;
}

std::vector<std::string> takersOfWholeWorlds(const std::set<std::string>& allowed, const Ranks& ranks,
                                             const std::vector<SourceFile>& kit) {
    static const std::regex taken(R"(\bWorldState\s*[&*])");
    std::vector<std::string> faults;
    for (const SourceFile& source : kit)
        if (!allowed.contains(roomOf(source.path, ranks)) && std::regex_search(source.text, taken))
            faults.push_back(source.path + " takes a WorldState: say which of its stores");
    return faults;
}

std::vector<std::string> tooLarge(const Sizes& most, const std::vector<SourceFile>& sources) {
    std::vector<std::string> faults;
    std::map<std::string, std::size_t> filesIn;
    for (const SourceFile& source : sources) {
        ++filesIn[source.path.substr(0, source.path.rfind('/') + 1)];
        const std::vector<std::string> lines = linesOf(source.text);
        if (lines.size() > most.fileLines)
            faults.push_back(source.path + " has " + std::to_string(lines.size()) + " lines");
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!opensFunction(lines[i])) continue;
            const std::string close = std::string(lines[i].find_first_not_of(' '), ' ') + "}";
            const auto end = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end(),
                                          [&](const std::string& line) { return line.starts_with(close); });
            const std::size_t length = static_cast<std::size_t>(end - lines.begin()) - i - 1;
            if (length > most.functionLines)
                faults.push_back(source.path + ": " + std::to_string(length) + " lines of " + lines[i]);
        }
    }
    for (const auto& [folder, files] : filesIn)
        if (files > most.files) faults.push_back(folder + " has " + std::to_string(files) + " files");
    return faults;
}

}  // namespace plumb::test
