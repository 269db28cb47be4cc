// SPDX-License-Identifier: MIT
// What would results look like whose numbers are known?
#pragma once
#include <string>
#include <utility>
#include <vector>

#include <compare/bench/result.h>

namespace plumb::compare {

/// An engine whose runs took so many milliseconds a step.
inline EngineBench measuredEngine(const std::string& engine, const std::vector<double>& milliseconds,
                                  long peakKb = 2048) {
    EngineBench bench{.engine = engine, .version = engine == subjectName() ? "0.1.0" : "2.4.1"};
    for (const double ms : milliseconds)
        bench.runs.push_back({.bodies = 10,
                              .steps = 5,
                              .msPerStep = ms,
                              .stepMs = {1 * ms, 2 * ms, 3 * ms, 4 * ms, 5 * ms},
                              .peakKb = peakKb,
                              .phases = {{"solve", ms / 2000}}});
    return bench;
}

inline EngineBench unableEngine(const std::string& engine) {
    return {.engine = engine, .version = "1", .runs = {{.unsupported = "it has no such thing"}}};
}

inline SceneBench measuredScene(const std::string& name, std::vector<EngineBench> engines,
                                const std::string& family = "", std::size_t bodies = 10) {
    return {.scene = name, .family = family, .bodies = bodies, .steps = 5, .engines = std::move(engines)};
}

/// One that a group stands for.
inline SceneBench memberOf(const std::string& group, SceneBench scene) {
    scene.group = group;
    return scene;
}

}  // namespace plumb::compare
