// SPDX-License-Identifier: MIT
#include "house/arrows.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace plumb::test {
namespace {

constexpr std::string_view umbrella = "plumb/plumb.h";

bool isHeader(std::string_view path) {
    return path.ends_with(".h");
}

std::string arrow(const std::string& from, const std::string& to, const std::string& why) {
    return from + " includes " + to + ": " + why;
}

std::string rankOf(const Ranks& ranks, const std::string& module) {
    const auto found = ranks.find(module);
    return "`" + module + "` has " + (found == ranks.end() ? "no rank" : "rank " + std::to_string(found->second));
}

}  // namespace

Ranks ranksOf(std::string_view readme, const std::string& what) {
    const std::regex head(R"(^\|\s*rank\s*\|\s*)" + what + R"(\s*\|.*$)");
    static const std::regex row(R"(^\|\s*(\d+)\s*\|([^|]*)\|.*$)");
    static const std::regex name("`([a-z_0-9.]+/?)`");
    Ranks ranks;
    bool inTable = false;
    std::istringstream lines{std::string(readme)};
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, head)) inTable = true;
        if (!line.starts_with('|')) inTable = false;
        std::smatch match;
        if (!inTable || !std::regex_match(line, match, row)) continue;
        const int rank = std::stoi(match[1]);
        const std::string text = match[2];
        for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it)
            ranks.try_emplace((*it)[1], rank);
    }
    return ranks;
}

Ranks ranksIn(std::string_view readme, const std::set<std::string>& modules) {
    Ranks ranks = ranksOf(readme, "modules");
    std::erase_if(ranks, [&](const auto& rank) { return !modules.contains(rank.first); });
    return ranks;
}

std::string folderUnder(std::string_view root, std::string_view path) {
    if (!path.starts_with(root) || !path.substr(root.size()).starts_with('/')) return {};
    path.remove_prefix(root.size() + 1);
    return std::string(path.substr(0, path.find('/')));
}

std::string moduleOf(std::string_view path) {
    const std::string folder = folderUnder("plumb", path);
    return folder.find('.') == std::string::npos ? folder : "";
}

std::vector<std::string> includesOf(std::string_view text) {
    static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*$)");
    std::vector<std::string> found;
    std::istringstream lines{std::string(text)};
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, match, include)) found.push_back(match[1]);
    return found;
}

std::vector<std::string> upwardArrows(const Ranks& ranks, const std::vector<SourceFile>& sources,
                                      std::string_view root) {
    std::vector<std::string> faults;
    std::set<std::string> unranked;
    for (const SourceFile& source : sources) {
        if (source.path == umbrella) continue;
        const std::string from = folderUnder(root, source.path);
        if (!ranks.contains(from) && unranked.insert(from).second) faults.push_back(rankOf(ranks, from));
        for (const std::string& include : includesOf(source.text)) {
            const std::string to = folderUnder(root, include);
            if (include.find("..") != std::string::npos)
                faults.push_back(arrow(source.path, include, "a path that hides the module"));
            else if (include == umbrella && source.path.starts_with("plumb/"))
                faults.push_back(arrow(source.path, include, "that is every rank at once"));
            else if (!to.empty() && to != from && ranks.contains(from) &&
                     (!ranks.contains(to) || ranks.at(to) >= ranks.at(from)))
                faults.push_back(arrow(source.path, include, rankOf(ranks, from) + ", " + rankOf(ranks, to)));
        }
    }
    return faults;
}

std::vector<std::string> arrowsInto(std::string_view folder, const std::vector<SourceFile>& sources) {
    const std::string prefix = std::string(folder) + "/";
    std::vector<std::string> faults;
    for (const SourceFile& source : sources)
        for (const std::string& include : includesOf(source.text))
            if (include.starts_with(prefix) || include.find("/" + prefix) != std::string::npos)
                faults.push_back(arrow(source.path, include, "these two never meet"));
    return faults;
}

std::vector<std::string> arrowsOutOfGames(const std::vector<SourceFile>& games) {
    std::vector<std::string> faults;
    for (const SourceFile& source : games) {
        const std::string own = source.path.substr(0, source.path.rfind('/') + 1);
        const std::string folder = source.path.substr(0, source.path.find('/', sizeof "games") + 1);
        const bool shell = folder == "games/shell/";
        for (const std::string& include : includesOf(source.text)) {
            const bool standard = include.find_first_of("./") == std::string::npos;
            const bool kit = include.starts_with("plumb/") || include.starts_with("games/frame/");
            const bool ownFolder = include.starts_with(folder.empty() ? own : folder);
            const bool platform = !include.starts_with("games/");
            if (!standard && !kit && !ownFolder && !(shell && platform))
                faults.push_back(arrow(source.path, include, "a game knows the kit, the frame and itself"));
        }
    }
    return faults;
}

bool isInstalled(std::string_view path) {
    return path.starts_with("plumb/") && isHeader(path) && std::count(path.begin(), path.end(), '/') <= 2;
}

std::vector<std::string> arrowsOutOfInstalled(const std::vector<SourceFile>& kit) {
    std::vector<std::string> faults;
    for (const SourceFile& source : kit) {
        if (!isInstalled(source.path)) continue;
        for (const std::string& include : includesOf(source.text))
            if (include.starts_with("plumb/") && !isInstalled(include))
                faults.push_back(arrow(source.path, include, "that is not installed"));
    }
    return faults;
}

std::vector<std::string> ownHeadersNotFirst(const std::vector<SourceFile>& kit) {
    std::set<std::string> paths;
    for (const SourceFile& source : kit) paths.insert(source.path);
    std::vector<std::string> faults;
    for (const SourceFile& source : kit) {
        if (isHeader(source.path)) continue;
        const std::string own = source.path.substr(0, source.path.rfind('.')) + ".h";
        const std::vector<std::string> includes = includesOf(source.text);
        if (paths.contains(own) && (includes.empty() || includes.front() != own))
            faults.push_back(source.path + " does not include " + own + " first");
    }
    return faults;
}

}  // namespace plumb::test
