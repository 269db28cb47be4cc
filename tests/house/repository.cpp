// SPDX-License-Identifier: MIT
#include "house/repository.h"

#include <regex>

#include <algorithm>
#include <sstream>

#include "house/shell.h"

namespace plumb::test {

namespace {

std::vector<std::filesystem::path> filesThatGitKnows() {
    const std::string root = repository.string();
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(repository / ".git")) return files;  // or a git around it would answer
    const Ran ran = shell("git -C " + quoted(root) + " ls-files -z -co --exclude-standard 2>/dev/null");
    std::istringstream names(ran.output);
    for (std::string name; ran.ok && std::getline(names, name, '\0');) files.emplace_back(name);
    return files;
}

std::vector<std::filesystem::path> allFilesButBuilt() {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path root = repository;
    for (std::filesystem::recursive_directory_iterator it(root), end; it != end; ++it) {
        const std::filesystem::path path = it->path().lexically_relative(root);
        if (path == "build" || path == ".git")
            it.disable_recursion_pending();
        else
            files.push_back(path);
    }
    return files;
}

}  // namespace

std::vector<std::filesystem::path> repositoryFiles() {
    std::vector<std::filesystem::path> files = filesThatGitKnows();
    if (files.empty()) files = allFilesButBuilt();
    // Git knows what has been deleted as well, until a commit says so.
    std::erase_if(files, [](const auto& file) { return !is_regular_file(repository / file); });
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

std::vector<std::string> testNamesIn(const std::vector<SourceFile>& sources) {
    static const std::regex test(R"re(\bTEST_CASE\(\s*"((?:[^"\\]|\\.)*)")re");
    std::vector<std::string> names;
    for (const SourceFile& source : sources)
        for (std::sregex_iterator each(source.text.begin(), source.text.end(), test), end; each != end; ++each)
            names.push_back((*each)[1]);
    return names;
}

}  // namespace plumb::test
