// SPDX-License-Identifier: MIT
#include <compare/command/arguments.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <compare/scene/bench.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

/// Option values as they are written on the command line.
struct Raw {
    std::vector<std::string> scenes;
    std::string word, engines, steps, dt, mine, json, csv, report, repeat, threads;
    std::vector<std::string> readme, verify, set;
    PrintOptions print;
};

/// The whole text as a number; empty if it is not one.
template <class Number>
std::optional<Number> number(const std::string& text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end) return {};
    return value;
}

int countFrom(const std::string& option, const std::string& text) {
    const std::optional<int> count = number<int>(text);
    if (!count || *count < 1)
        throw std::invalid_argument(fmt::format("{}: \"{}\" is not a whole number of at least 1", option, text));
    return *count;
}

void requireOneThread(const std::string& text) {
    if (const int threads = countFrom("--threads", text); threads > 1)
        throw std::invalid_argument(fmt::format("--threads: {} is not 1: Plumb steps on one thread so far", threads));
}

double dtFrom(const std::string& text) {
    const std::optional<double> dt = numberOf(text);
    if (!dt || !std::isfinite(*dt) || *dt <= 0)
        throw std::invalid_argument(fmt::format("--dt: \"{}\" is not a positive number of seconds", text));
    return *dt;
}

std::vector<std::string> enginesFrom(const std::string& text, const std::vector<Engine>& known) {
    std::vector<std::string> names, usual, others, result;
    for (const Engine& engine : known) {
        names.push_back(engine.name);
        (engine.onDemand ? others : usual).push_back(engine.name);
    }
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        const std::string name = text.substr(start, comma - start);
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            const Engine* absent = findKnown(name);
            const std::string hint = absent && !absent->missing.empty() ? "; " + absent->missing : "";
            const std::string more = others.empty() ? "" : fmt::format("; for lessons {}", fmt::join(others, ", "));
            throw std::invalid_argument(
                fmt::format("--engines: \"{}\" is not an engine of this build, which has {}{}{}", name,
                            fmt::join(usual, ", "), more, hint));
        }
        result.push_back(name);
        start = comma + 1;
    }
    return result;
}

std::filesystem::path pathFrom(const std::string& option, const std::string& text) {
    if (text.empty()) throw std::invalid_argument(option + ": \"\" is not a path");
    return text;
}

struct Commands {
    CLI::App *list, *check, *bench, *exportScene, *schema, *lesson;
};

void describeSet(CLI::App& command, Raw& raw) {
    command
        .add_option("--set", raw.set,
                    "give a field of the scene another value, as dt=1/240, bodies.ball.velocity=15,26 or "
                    "bodies.ball.friction=0.3; the path is that of the JSON, a list's elements by name or number from "
                    "0; may be given again")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
}

CLI::App* describeCheck(CLI::App& app, Raw& raw) {
    CLI::App* check = app.add_subcommand("check", "run scenes and labs, and judge them");
    check->footer(
        "A check that looks at what a shortened run does not reach fails. A scene without checks, or\n"
        "none of whose checks binds the engines asked for, is shown and not judged: it does not change the exit\n"
        "status. A lab varies one quantity and draws curves over it, with steps of its own: --steps and --dt are\n"
        "for scenes. A lab compares those of its engines that are asked for.");
    check->add_option("SCENE", raw.scenes,
                      "names of scenes and labs, files: FILE.json, or random:SEED, random:A..B; without any, all "
                      "built-in ones");
    check->add_option("--engines", raw.engines, "the engines to run, instead of all")->type_name("A,B");
    check->add_option("--steps", raw.steps, "how many steps to run, instead of the scene's")->type_name("N");
    check->add_option("--dt", raw.dt, "length of a step, instead of the scene's [s]")->type_name("S");
    describeSet(*check, raw);
    check
        ->add_option("--mine", raw.mine,
                     "show also what you measured or calculated in one scene: a table with columns t [s], x [m] and "
                     "y [m] of a body, which a column body may name; else it is the first dynamic one")
        ->type_name("FILE");
    check->add_option("--json", raw.json, "write metrics and verdicts to this file")->type_name("FILE");
    check
        ->add_option("--csv", raw.csv,
                     "write what each engine did, tick by tick, into this folder, a file a scene and engine; curves, a "
                     "file a lab")
        ->type_name("DIR");
    check->add_option("--report", raw.report, "write the report into this folder: index.html")->type_name("DIR");
    check->add_option("--readme", raw.readme, "write the tables of accuracy into this page; may be given again")
        ->type_name("FILE")
        ->allow_extra_args(false);
    check
        ->add_option(
            "--verify", raw.verify,
            "compare the tables of this page with what is measured: Plumb's to the digit, those of engines that each "
            "build has within a factor of two; may be given again")
        ->type_name("FILE")
        ->allow_extra_args(false);
    return check;
}

CLI::App* describeBench(CLI::App& app, Raw& raw) {
    CLI::App* bench = app.add_subcommand("bench", "measure how long engines take for scenes");
    std::vector<std::string> names;
    for (const BenchScene& scene : benchScenes()) names.push_back(scene.name);
    bench->footer(fmt::format(
        "Engines run in turn, each run in a process of its own; a ratio above 1 means that Plumb is faster.\nScenes: "
        "six (the first six, which is what runs without a name), scaling (a heap and pyramids of {} sizes), crowds "
        "(bodies that bounce), jointed (structures of joints), {};\nrandom:SEED or random:A..B "
        "(a random scene a seed, the same on every machine); any other scene, or FILE.json.",
        findBenchScenes("scaling").size(), fmt::join(names, ", ")));
    bench->add_option("SCENE", raw.scenes, "names of scenes or groups of them, or files");
    bench->add_option("--repeat", raw.repeat, "runs of each engine in each scene, instead of 5")->type_name("N");
    bench->add_option("--threads", raw.threads, "threads of each engine; only 1 so far")->type_name("N");
    bench->add_option("--engines", raw.engines, "the engines to run, instead of all")->type_name("A,B");
    bench->add_option("--steps", raw.steps, "how many steps to run, instead of the scene's")->type_name("N");
    bench->add_option("--json", raw.json, "write all numbers to this file")->type_name("FILE");
    bench->add_option("--readme", raw.readme, "write the tables of speed into this page; may be given again")
        ->type_name("FILE")
        ->allow_extra_args(false);
    return bench;
}

CLI::App* describeExport(CLI::App& app, Raw& raw) {
    CLI::App* command = app.add_subcommand("export", "print a scene as JSON");
    command->add_option("SCENE", raw.scenes, "name of a scene, random:SEED, or FILE.json")->required()->expected(1);
    command->add_flag("--all", raw.print.all, "with every field, those that have their defaults too");
    describeSet(*command, raw);
    command->footer("");
    return command;
}

Commands describe(CLI::App& app, Raw& raw) {
    app.require_subcommand(0, 1);
    app.footer(
        "Without a command: every scene in every engine, every lab, and the report in build/report/index.html.\n"
        "Exit status: 0 no check fails, 1 a check fails, 2 bad usage or input.");
    CLI::App* list = app.add_subcommand("list", "scenes and labs by group: name, question, engines, checks");
    list->add_option("WORD", raw.word,
                     "only those whose name, group or question contains this, in small or capital letters");
    CLI::App* check = describeCheck(app, raw);
    CLI::App* bench = describeBench(app, raw);
    CLI::App* exportScene = describeExport(app, raw);
    CLI::App* schema = app.add_subcommand("schema", "print what a scene's JSON may hold, as a JSON Schema");
    schema->add_flag("--page", raw.print.page, "as tables to read, in Markdown");
    CLI::App* lesson = app.add_subcommand("lesson", "read lessons, and print them with the numbers of their runs");
    lesson->add_option("FILE.json", raw.scenes, "files of lessons")->required();
    lesson->add_option("--json", raw.json, "write the numbers to this file")->type_name("FILE");
    for (CLI::App* command : {schema, list, lesson}) command->footer("");
    return {list, check, bench, exportScene, schema, lesson};
}

std::vector<FieldSetting> settingsFrom(const std::vector<std::string>& texts) {
    std::vector<FieldSetting> settings;
    try {
        for (const std::string& text : texts) settings.push_back(fieldSettingOf(text));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("--set: {}", error.what()));
    }
    return settings;
}

/// The message of the options' reader, or which command was probably meant.
std::string usageError(const CLI::App& app, std::span<const std::string> args, const std::string& said) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::string given = args.empty() ? "" : args.front();
    if (given.empty() || given.starts_with('-') || std::ranges::find(names, given) != names.end())
        return fmt::format("{}; --help tells what is understood", said);
    return fmt::format("\"{}\" is not a command, the nearest is {}; known are {}", given, nearest(given, names),
                       listText(names));
}

void takeCheck(const CLI::App& check, const Raw& raw, const std::vector<Engine>& known, Arguments& result) {
    result.action = Action::CheckScenes;
    const auto given = [&](const char* option) { return check.count(option) > 0; };
    if (given("--engines")) result.options.engines = enginesFrom(raw.engines, known);
    if (given("--steps")) result.options.steps = countFrom("--steps", raw.steps);
    if (given("--dt")) result.options.dt = dtFrom(raw.dt);
    if (given("--mine")) result.mine = pathFrom("--mine", raw.mine);
    if (given("--json")) result.json = pathFrom("--json", raw.json);
    if (given("--csv")) result.csv = pathFrom("--csv", raw.csv);
    if (given("--report")) result.report = pathFrom("--report", raw.report);
    for (const std::string& page : raw.readme) result.pages.written.push_back(pathFrom("--readme", page));
    for (const std::string& page : raw.verify) result.pages.verified.push_back(pathFrom("--verify", page));
}

void takeBench(const CLI::App& bench, const Raw& raw, const std::vector<Engine>& known, Arguments& result) {
    result.action = Action::Bench;
    const auto given = [&](const char* option) { return bench.count(option) > 0; };
    std::vector<Engine> simulators = known;
    std::erase_if(simulators, [](const Engine& engine) { return engine.role == Role::Truth; });
    if (given("--engines")) result.bench.engines = enginesFrom(raw.engines, simulators);
    if (given("--repeat")) result.bench.repeat = countFrom("--repeat", raw.repeat);
    if (given("--threads")) requireOneThread(raw.threads);
    if (given("--steps")) result.bench.steps = countFrom("--steps", raw.steps);
    if (given("--json")) result.json = pathFrom("--json", raw.json);
    for (const std::string& page : raw.readme) result.pages.written.push_back(pathFrom("--readme", page));
}

}  // namespace

Arguments parseArguments(std::span<const std::string> args, const std::vector<Engine>& known) {
    CLI::App app("Runs the same scene in several engines and the closed form, and says which agree.", "plumb-compare");
    Raw raw;
    const Commands commands = describe(app, raw);
    Arguments result;
    try {
        app.parse(std::vector<std::string>(args.rbegin(), args.rend()));  // CLI11 takes them from the back
    } catch (const CLI::CallForHelp&) {
        result.action = Action::Help;
        result.help = app.help();
        return result;
    } catch (const CLI::ParseError& error) {
        throw std::invalid_argument(usageError(app, args, error.what()));
    }
    result.scenes = raw.scenes;
    result.word = raw.word;
    result.print = raw.print;
    result.set = settingsFrom(raw.set);
    if (commands.list->parsed()) result.action = Action::ListScenes;
    if (commands.exportScene->parsed()) result.action = Action::ExportScene;
    if (commands.schema->parsed()) result.action = Action::PrintSchema;
    if (commands.lesson->parsed()) {
        result.action = Action::ReadLessons;
        if (commands.lesson->count("--json") > 0) result.json = pathFrom("--json", raw.json);
    }
    if (commands.check->parsed()) takeCheck(*commands.check, raw, known, result);
    if (commands.bench->parsed()) takeBench(*commands.bench, raw, known, result);
    return result;
}

}  // namespace plumb::compare
