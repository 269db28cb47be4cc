// SPDX-License-Identifier: MIT
#include <compare/command/command.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <compare/command/arguments.h>
#include <compare/command/bench_command.h>
#include <compare/command/lab_text.h>
#include <compare/command/lesson_command.h>
#include <compare/command/output_file.h>
#include <compare/command/page_files.h>
#include <compare/command/scene_choice.h>
#include <compare/command/scene_list.h>
#include <compare/command/verdict_table.h>
#include <compare/engine/engines.h>
#include <compare/report/report.h>
#include <compare/scene/json.h>
#include <compare/scene/scene_file.h>
#include <compare/scene/schema/schema.h>
#include <compare/view/verdict_json.h>

namespace plumb::compare {
namespace {

constexpr const char* defaultReport = "build/report";  // in the folder where the program is called

void makeFolder(const std::string& option, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw std::runtime_error(fmt::format("{}: cannot make the folder {}", option, folder.string()));
}

/// The engines that have a column: those asked for, without the closed form. The others are compared with the closed
/// form.
std::vector<std::string> columns(const RunOptions& options, const std::vector<Engine>& engines) {
    std::vector<std::string> result;
    for (const Engine& engine : engines) {
        const auto& asked = options.engines;
        const bool runs = asked.empty() || std::find(asked.begin(), asked.end(), engine.name) != asked.end();
        if (runs && engine.role != Role::Truth) result.push_back(engine.name);
    }
    return result;
}

void refuseSceneOptions(const Arguments& arguments, const std::vector<Lab>& labs) {
    if (arguments.scenes.empty() || labs.empty()) return;
    const auto refuse = [&](const char* option) {
        throw std::invalid_argument(
            fmt::format("{}: {} is a lab, and has steps of its own", option, labs.front().name));
    };
    if (arguments.options.steps) refuse("--steps");
    if (arguments.options.dt) refuse("--dt");
    if (!arguments.set.empty()) refuse("--set");
}

/// Sets the fields in each scene.
void setFields(std::vector<Scene>& scenes, const std::vector<FieldSetting>& settings) {
    if (settings.empty()) return;
    try {
        for (Scene& scene : scenes) scene = withFields(std::move(scene), settings);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("--set {}", error.what()));
    }
}

/// The engine that shows the user's track, for one scene.
Engine engineOfTrack(const std::filesystem::path& file, const Choice& choice, const std::vector<std::string>& named) {
    if (named.empty()) throw std::invalid_argument("--mine: no scene is named, wanted one");
    if (!choice.labs.empty())
        throw std::invalid_argument(fmt::format("--mine: {} is a lab, wanted a scene", choice.labs.front().name));
    if (choice.scenes.size() != 1)
        throw std::invalid_argument(
            fmt::format("--mine: {} is {} scenes, wanted one", fmt::join(named, " "), choice.scenes.size()));
    return mineEngine(ownTrackFrom(readText(file, "a table with columns t, x and y"), file.string()));
}

/// isTold: print where engines part, one sentence for each pair.
std::vector<SceneResult> runScenes(const std::vector<Scene>& scenes, const RunOptions& options,
                                   const std::vector<Engine>& engines, std::ostream& out, bool colour, bool isTold) {
    std::vector<SceneResult> results;
    if (scenes.empty()) return results;
    const VerdictTable table(out, columns(options, engines), scenes, colour);
    table.head();
    for (const Scene& scene : scenes) {
        try {
            results.push_back(runScene(scene, options, engines));
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("scene {}: {}", scene.name, error.what()));
        }
        table.row(results.back());
        if (isTold) table.partings(results.back());
    }
    table.summary(results);
    return results;
}

std::vector<LabResult> runLabs(const std::vector<Lab>& labs, const RunOptions& options, std::ostream& out,
                               bool colour) {
    std::vector<LabResult> results;
    if (labs.empty()) return results;
    fmt::print(out, "{:6}lab, and what was measured in it\n", "");
    for (const Lab& lab : labs) {
        try {
            results.push_back(runLab(lab, options.engines, enginesWith(options.engines)));
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("lab {}: {}", lab.name, error.what()));
        }
        printLab(results.back(), out, colour);
    }
    printLabSummary(results, out, colour);
    return results;
}

int check(const Arguments& arguments, std::ostream& out, bool colour) {
    Choice choice = chooseScenesAndLabs(arguments.scenes);
    refuseSceneOptions(arguments, choice.labs);
    setFields(choice.scenes, arguments.set);
    RunOptions options = arguments.options;
    options.inDetail = !arguments.scenes.empty() || arguments.report;
    for (const FieldSetting& setting : arguments.set)
        options.changed.push_back(fmt::format("{} = {}", setting.path, setting.value));
    std::vector<Engine> shown = enginesWith(options.engines);
    if (arguments.mine) {
        shown.push_back(engineOfTrack(*arguments.mine, choice, arguments.scenes));
        if (!options.engines.empty()) options.engines.push_back(shown.back().name);
    }
    std::optional<OutputFile> json;
    if (arguments.json) json.emplace("--json", *arguments.json);
    if (arguments.csv) makeFolder("--csv", *arguments.csv);
    if (arguments.report) makeFolder("--report", *arguments.report);
    const AccuracyPages pages(arguments, engines());
    const std::vector<SceneResult> scenes =
        runScenes(choice.scenes, options, shown, out, colour, !arguments.scenes.empty());
    if (!choice.scenes.empty() && !choice.labs.empty()) fmt::print(out, "\n");
    const std::vector<LabResult> labs = runLabs(choice.labs, arguments.options, out, colour);
    if (json) json->write(verdictJson(scenes, labs));
    if (arguments.csv) {
        writeCsv(scenes, *arguments.csv);
        writeLabCsv(labs, *arguments.csv);
    }
    if (arguments.report) {
        writeReport(scenes, *arguments.report, labs);
        fmt::print(out, "Report: {}\n", (*arguments.report / "index.html").string());
    }
    const bool pagesHold = pages.hold(scenes, out);
    const bool fails = std::max(overallVerdict(scenes), overallVerdict(labs)) == Verdict::Fails;
    return fails || !pagesHold ? checkFails : noneFails;
}

void list(const Arguments& arguments, std::ostream& out) {
    listByGroup(containing(chooseScenesAndLabs({}), arguments.word), engines(), out);
}

int checkEverything(Arguments arguments, std::ostream& out, bool colour) {
    arguments.report = defaultReport;
    const std::vector<Engine>& known = engines();
    for (const Engine& engine : known)
        if (!engine.version.empty()) fmt::print(out, "{} {}\n", engine.name, engine.version);
    for (const Engine& engine : knownEngines())
        if (!engine.build && !engine.onDemand)
            fmt::print(out, "{} is not in this build; for it {}\n", engine.name, engine.missing);
    fmt::print(out, "\n");
    return check(arguments, out, colour);
}

void exportScene(const Arguments& arguments, std::ostream& out) {
    const std::vector<std::string>& given = arguments.scenes;
    std::vector<Scene> scenes = chooseScenes(given);
    if (scenes.size() != 1)
        throw std::invalid_argument(
            fmt::format("export: {} is {} scenes, wanted one", fmt::join(given, " "), scenes.size()));
    setFields(scenes, arguments.set);
    fmt::print(out, "{}\n", toJson(scenes.front(), arguments.print.all ? Defaults::Written : Defaults::LeftOut));
}

void printSchema(const Arguments& arguments, std::ostream& out) {
    fmt::print(out, "{}\n", arguments.print.page ? sceneSchemaPage() : sceneSchema());
}

int run(const Arguments& arguments, std::ostream& out, bool colour) {
    switch (arguments.action) {
        case Action::Help: fmt::print(out, "{}", arguments.help); return noneFails;
        case Action::ListScenes: list(arguments, out); return noneFails;
        case Action::ExportScene: exportScene(arguments, out); return noneFails;
        case Action::PrintSchema: printSchema(arguments, out); return noneFails;
        case Action::ReadLessons: runLessons(arguments, out); return noneFails;
        case Action::Bench: runBench(arguments, enginesWith(arguments.bench.engines), out); return noneFails;
        case Action::CheckScenes: return check(arguments, out, colour);
        case Action::Everything: break;
    }
    return checkEverything(arguments, out, colour);
}

std::string oneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

int runCommand(std::span<const std::string> args, std::ostream& out, std::ostream& err, bool colour) {
    try {
        return run(parseArguments(args, enginesWith(namesOf(knownEngines()))), out, colour);
    } catch (const std::exception& error) {
        fmt::print(err, "plumb-compare: {}\n", oneLine(error.what()));
        return badInput;
    }
}

}  // namespace plumb::compare
