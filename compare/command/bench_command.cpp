// SPDX-License-Identifier: MIT
#include <compare/command/bench_command.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include <compare/bench/bench_json.h>
#include <compare/bench/bench_table.h>
#include <compare/command/output_file.h>
#include <compare/command/page_files.h>
#include <compare/command/scene_choice.h>
#include <compare/page/speed_tables.h>

namespace plumb::compare {
namespace {

std::vector<Engine> chosenEngines(const BenchOptions& options, const std::vector<Engine>& engines) {
    std::vector<Engine> chosen;
    for (const Engine& engine : engines) {
        const bool asked =
            options.engines.empty() || std::ranges::find(options.engines, engine.name) != options.engines.end();
        if (asked && engine.role != Role::Truth) chosen.push_back(engine);
    }
    return chosen;
}

BenchRun measureOnce(const BenchScene& scene, const Engine& engine, const MeasureOptions& options) {
    if (std::string reason = engine.leavesOut ? engine.leavesOut(scene) : ""; !reason.empty())
        return {.unsupported = std::move(reason)};
    return measureRun(scene.build, engine, options);
}

/// A slow engine is not run again: one run takes longer than longRun [s], and longer than manyTimes the run of the
/// fastest engine [-]. Other work of the machine cannot cause so large a difference.
constexpr double longRun = 10, manyTimes = 8;

bool isRunAgain(const EngineBench& bench, const SceneBench& scene) {
    if (!bench.supported()) return false;
    double fastest = bench.runs.front().seconds();
    for (const EngineBench& other : scene.engines)
        if (other.supported()) fastest = std::min(fastest, other.runs.front().seconds());
    const double own = bench.runs.front().seconds();
    return own <= longRun || own <= manyTimes * fastest;
}

/// The engines run in turn, A B A B: if something slows the machine for a while, it slows all of them.
SceneBench measureScene(const BenchScene& scene, const BenchOptions& options, const std::vector<Engine>& engines) {
    SceneBench result{.scene = scene.name, .group = scene.group, .family = scene.family};
    for (const Engine& engine : engines) result.engines.push_back({engine.name, engine.version, {}});
    for (int repeat = 0; repeat < options.repeat; ++repeat) {
        for (std::size_t i = 0; i < engines.size(); ++i) {
            EngineBench& bench = result.engines[i];
            if (repeat > 0 && !isRunAgain(bench, result)) continue;
            bench.runs.push_back(measureOnce(scene, engines[i], {.steps = options.steps, .look = repeat == 0}));
            if (!bench.supported()) continue;
            const BenchRun& run = bench.runs.back();
            result.question = run.question;
            result.bodies = run.bodies;
            result.joints = run.joints;
            result.steps = run.steps;
        }
    }
    return result;
}

}  // namespace

void runBench(const Arguments& arguments, const std::vector<Engine>& engines, std::ostream& out) {
    const std::vector<BenchScene> scenes = chooseBenchScenes(arguments.scenes);
    const std::vector<Engine> chosen = chosenEngines(arguments.bench, engines);
    std::optional<OutputFile> json;
    if (arguments.json) json.emplace("--json", *arguments.json);
    const PageFiles pages(arguments.pages.written, "bench");  // so a wrong file is reported at once
    const BenchTable table(out,
                           std::ranges::max(scenes, {}, [](const BenchScene& s) { return s.name.size(); }).name.size());
    table.head();
    std::vector<SceneBench> results;
    for (const BenchScene& scene : scenes) {
        try {
            results.push_back(measureScene(scene, arguments.bench, chosen));
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("scene {}: {}", scene.name, error.what()));
        }
        table.rows(results.back());
    }
    table.summary(results);
    if (json) json->write(benchJson(results));
    if (!pages.empty()) pages.write(speedBlocks(results), out);
}

}  // namespace plumb::compare
