// SPDX-License-Identifier: MIT
// What was asked for on the command line?
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

enum class Action {
    Everything,  ///< no arguments: all scenes and engines, and the report
    ListScenes,
    CheckScenes,
    ExportScene,
    Help,
};

struct Arguments {
    Action action = Action::Everything;
    std::vector<std::string> scenes;  ///< names and files, as given
    RunOptions options;
    std::optional<std::filesystem::path> json, csv, report;
    std::string help;  ///< to be printed for Help
};

/// Throws std::invalid_argument saying which argument is wrong and what was wanted. known: the engines of this build.
Arguments parseArguments(std::span<const std::string> args, const std::vector<Engine>& known);

}  // namespace plumb::compare
