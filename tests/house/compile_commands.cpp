// SPDX-License-Identifier: MIT
#include "house/compile_commands.h"

#include <sstream>

#include "catch.h"
#include "house/repository.h"

namespace plumb::test {

namespace {

/// CMake writes a field a line: "command": "...",
std::string fieldIn(const std::string& line, const std::string& name) {
    const std::string start = "\"" + name + "\": \"";
    const std::size_t found = line.find(start);
    if (found == std::string::npos) return "";
    std::string field;
    for (std::size_t i = found + start.size(); i < line.size() && line[i] != '"'; ++i) {
        if (line[i] == '\\') ++i;  // what follows stands for itself
        if (i < line.size()) field += line[i];
    }
    return field;
}

}  // namespace

bool CompileCommand::has(std::string_view word) const {
    std::istringstream words(command);
    for (std::string each; words >> each;)
        if (each == word) return true;
    return false;
}

std::string CompileCommand::optimisation() const {
    std::string last;
    std::istringstream words(command);
    for (std::string each; words >> each;)
        if (each.starts_with("-O")) last = each;
    return last;
}

std::vector<CompileCommand> compileCommandsIn(const std::filesystem::path& build) {
    std::vector<CompileCommand> commands;
    std::istringstream lines(textOf(build / "compile_commands.json"));
    std::string command;
    for (std::string line; std::getline(lines, line);) {
        if (const std::string field = fieldIn(line, "command"); !field.empty()) command = field;
        if (const std::string field = fieldIn(line, "file"); !field.empty()) commands.push_back({field, command});
    }
    REQUIRE_FALSE(commands.empty());
    return commands;
}

}  // namespace plumb::test
