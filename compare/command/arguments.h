// SPDX-License-Identifier: MIT
// What was asked for on the command line?
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/check/verdict.h>
#include <compare/scene/set_field.h>

namespace plumb::compare {

enum class Action {
    Everything,  ///< no arguments: all scenes, labs and engines, and the report
    ListScenes,
    CheckScenes,
    ExportScene,
    PrintSchema,
    ReadLessons,
    Bench,
    Help,
};

/// How to measure speed.
struct BenchOptions {
    std::vector<std::string> engines;  ///< names; empty: all engines that simulate
    int repeat = 5;                    ///< runs of each engine in each scene
    std::optional<int> steps;          ///< instead of the scene's
};

/// How a scene and the schema of scenes are printed.
struct PrintOptions {
    bool all = false;   ///< also the fields that have their default value
    bool page = false;  ///< the schema as a page to read
};

/// Pages with tables of what is measured.
struct PageOptions {
    std::vector<std::filesystem::path> written;   ///< pages whose tables are to be replaced
    std::vector<std::filesystem::path> verified;  ///< pages whose tables are to be compared with what is measured now
};

struct Arguments {
    Action action = Action::Everything;
    std::vector<std::string> scenes;  ///< names of scenes and labs, and files, as given; of lessons, files
    std::string word;                 ///< that what is listed contains; empty: everything is listed
    RunOptions options;
    std::vector<FieldSetting> set;  ///< to be set in each scene
    PrintOptions print;
    BenchOptions bench;
    PageOptions pages;
    std::optional<std::filesystem::path> mine;  ///< a track of the user, to be shown beside the engines
    std::optional<std::filesystem::path> json, csv, report;
    std::string help;  ///< the text to print for Help
};

/// Throws std::invalid_argument, which says which argument is wrong and what was expected. known: the engines of this
/// build.
Arguments parseArguments(std::span<const std::string> args, const std::vector<Engine>& known);

}  // namespace plumb::compare
