// SPDX-License-Identifier: MIT
#include <compare/bench/measure.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <chrono>
#include <cstdint>
#include <ctime>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <compare/bench/apart.h>
#include <compare/bench/integrity.h>
#include <compare/bench/look_file.h>

namespace plumb::compare {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The processor time of this process [s].
double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The most memory that this process has had so far [KiB].
long peakKbSoFar() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    return usage.ru_maxrss / 1024;  // macOS counts bytes
#else
    return usage.ru_maxrss;
#endif
}

/// Returns freed memory to the system, so that it does not count for the next run.
void trimMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void add(std::vector<Phase>& sums, const std::vector<Phase>& phases) {
    if (sums.empty()) sums.resize(phases.size());
    for (std::size_t i = 0; i < phases.size(); ++i) {
        sums[i].name = phases[i].name;
        sums[i].seconds += phases[i].seconds;
    }
}

struct Started {
    std::unique_ptr<Simulation> simulation;
    double dt = 0;
    int steps = 0;
    std::string question;
    std::size_t bodies = 0, joints = 0;
};

/// The scene is freed when this returns, so its memory does not count as the engine's.
Started start(const std::function<Scene()>& source, const Engine& engine, std::optional<int> steps) {
    const Scene scene = source();
    return {engine.build(scene), scene.dt,           steps.value_or(stepCount(scene)), scene.question,
            scene.bodies.size(), scene.joints.size()};
}

/// Is there a look after this step? The looks are spread evenly over the steps; the last step has one.
bool isLook(int step, int steps) {
    constexpr std::int64_t looks = 32;
    const auto before = [&](int done) { return done * looks / steps; };
    return before(step + 1) > before(step);
}

struct Timed {
    std::vector<double> stepMs;
    std::vector<Phase> phases;       // sums over the steps [s]
    double processor = 0, wall = 0;  // of all steps [s]
    long peakKb = 0;
};

Timed timeSteps(const Started& started, LookFile* looks) {
    Timed timed;
    timed.stepMs.reserve(static_cast<std::size_t>(started.steps));
    for (int i = 0; i < started.steps; ++i) {
        const Clock::time_point begin = Clock::now();
        const double processorBegin = processorSeconds();
        started.simulation->step(started.dt);
        const double processor = processorSeconds() - processorBegin;
        timed.wall += secondsSince(begin);
        timed.processor += processor;
        timed.stepMs.push_back(processor * 1000);
        add(timed.phases, started.simulation->phases());
        if (looks != nullptr && isLook(i, started.steps))
            looks->write(started.simulation->states(), started.simulation->brokenJoints());
    }
    timed.peakKb = peakKbSoFar();
    return timed;
}

Integrity integrityOf(const Scene& scene, LookFile& looks) {
    IntegrityWatch watch(scene);
    std::vector<BodyState> states;
    Broken broken;
    while (looks.read(states, broken)) watch.look(states, broken);
    return watch.seen();
}

Json run(const std::function<Scene()>& source, const Engine& engine, const MeasureOptions& options) {
    Started started = start(source, engine, options.steps);
    trimMemory();
    std::optional<LookFile> looks;
    if (options.look) looks.emplace();
    const Timed timed = timeSteps(started, looks ? &*looks : nullptr);
    started.simulation.reset();
    Json report{{"question", started.question}, {"bodies", started.bodies},   {"joints", started.joints},
                {"steps", started.steps},       {"seconds", timed.processor}, {"busy", timed.processor / timed.wall},
                {"peak_kb", timed.peakKb}};
    report["step_ms"] = timed.stepMs;
    report["phases"] = Json::array();
    for (const Phase& phase : timed.phases) report["phases"].push_back({phase.name, phase.seconds / started.steps});
    if (looks) report["integrity"] = integrityJson(integrityOf(source(), *looks));
    return report;
}

/// Runs in the separate process. Never throws.
std::string reportOf(const std::function<Scene()>& source, const Engine& engine, const MeasureOptions& options) {
    Json report;
    try {
        report = run(source, engine, options);
    } catch (const Unsupported& reason) {
        report["unsupported"] = reason.what();
    } catch (const std::exception& error) {
        report["error"] = error.what();
    }
    return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

BenchRun measureRun(const std::function<Scene()>& scene, const Engine& engine, const MeasureOptions& options) {
    trimMemory();  // a new process starts with the memory of its parent
    const SpokenApart ended = runApart([&] { return reportOf(scene, engine, options); });
    if (WIFSIGNALED(ended.status))
        throw std::runtime_error(fmt::format("{} ended by signal {}", engine.name, WTERMSIG(ended.status)));
    const Json report = Json::parse(ended.text, nullptr, false);
    if (!report.is_object()) throw std::runtime_error(fmt::format("{} ended before its time", engine.name));
    if (report.contains("error"))
        throw std::runtime_error(fmt::format("{}: {}", engine.name, report["error"].get<std::string>()));
    BenchRun result;
    if (report.contains("unsupported")) {
        result.unsupported = report["unsupported"];
        return result;
    }
    result.question = report["question"];
    result.bodies = report["bodies"];
    result.joints = report["joints"];
    result.steps = report["steps"];
    result.msPerStep = report["seconds"].get<double>() * 1000 / result.steps;
    result.stepMs = report["step_ms"].get<std::vector<double>>();
    result.busy = report["busy"];
    result.peakKb = report["peak_kb"];
    if (report.contains("integrity")) result.integrity = integrityFrom(report["integrity"]);
    for (const Json& phase : report["phases"]) result.phases.push_back({phase[0], phase[1]});
    return result;
}

}  // namespace plumb::compare
