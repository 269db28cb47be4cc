// SPDX-License-Identifier: MIT
#include <compare/bench/measure.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace plumb::compare {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Lets go of what was freed, so that it does not count as memory of what comes now.
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
    std::size_t bodies = 0;
};

/// The scene is gone when this returns: its memory is not the engine's.
Started start(const std::function<Scene()>& source, const Engine& engine, std::optional<int> steps) {
    const Scene scene = source();
    return {engine.build(scene), scene.dt, steps.value_or(stepCount(scene)), scene.bodies.size()};
}

Json run(const std::function<Scene()>& source, const Engine& engine, std::optional<int> steps) {
    const Started started = start(source, engine, steps);
    trimMemory();
    std::vector<Phase> phases;
    double taken = 0;  // [s]
    std::vector<double> stepMs;
    stepMs.reserve(static_cast<std::size_t>(started.steps));
    const Clock::time_point begin = Clock::now();
    const double processorBegin = processorSeconds();
    for (int i = 0; i < started.steps; ++i) {
        const Clock::time_point stepBegin = Clock::now();
        started.simulation->step(started.dt);
        const double step = secondsSince(stepBegin);
        taken += step;
        stepMs.push_back(step * 1000);
        add(phases, started.simulation->phases());
    }
    const double busy = (processorSeconds() - processorBegin) / secondsSince(begin);
    Json report{{"bodies", started.bodies}, {"steps", started.steps}, {"seconds", taken}, {"busy", busy}};
    report["step_ms"] = stepMs;
    report["phases"] = Json::array();
    for (const Phase& phase : phases) report["phases"].push_back({phase.name, phase.seconds / started.steps});
    return report;
}

/// In the process of its own: never throws.
std::string reportOf(const std::function<Scene()>& source, const Engine& engine, std::optional<int> steps) {
    Json report;
    try {
        report = run(source, engine, steps);
    } catch (const Unsupported& reason) {
        report["unsupported"] = reason.what();
    } catch (const std::exception& error) {
        report["error"] = error.what();
    }
    return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void writeAll(int file, const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = write(file, text.data() + sent, text.size() - sent);
        if (count < 0 && errno != EINTR) return;
        if (count > 0) sent += static_cast<std::size_t>(count);
    }
}

std::string readAll(int file) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t count = read(file, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

struct Ended {
    std::string text;
    int status = 0;
    long peakKb = 0;
};

/// What a process of its own says, and how it ended.
Ended runApart(const std::function<std::string()>& speak) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("bench: the system gives no pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        writeAll(ends[1], speak());
        _exit(0);
    }
    close(ends[1]);
    Ended ended;
    if (child > 0) ended.text = readAll(ends[0]);
    close(ends[0]);
    if (child < 0) throw std::runtime_error("bench: the system gives no process");
    rusage usage{};
    while (wait4(child, &ended.status, 0, &usage) < 0 && errno == EINTR) {
    }
    ended.peakKb = usage.ru_maxrss;
#ifdef __APPLE__
    ended.peakKb /= 1024;  // macOS counts bytes
#endif
    return ended;
}

}  // namespace

BenchRun measureRun(const std::function<Scene()>& scene, const Engine& engine, std::optional<int> steps) {
    trimMemory();  // a process begins with what the one it comes from has
    const Ended ended = runApart([&] { return reportOf(scene, engine, steps); });
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
    result.bodies = report["bodies"];
    result.steps = report["steps"];
    result.msPerStep = report["seconds"].get<double>() * 1000 / result.steps;
    result.stepMs = report["step_ms"].get<std::vector<double>>();
    result.busy = report["busy"];
    result.peakKb = ended.peakKb;
    for (const Json& phase : report["phases"]) result.phases.push_back({phase[0], phase[1]});
    return result;
}

}  // namespace plumb::compare
