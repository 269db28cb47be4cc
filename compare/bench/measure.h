// SPDX-License-Identifier: MIT
// How long does an engine take for a scene, and how much memory?
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// One run of one scene in one engine.
struct BenchRun {
    std::string unsupported{};     ///< why the engine could not build the scene; empty when it could
    std::size_t bodies = 0;        ///< of the scene
    int steps = 0;                 ///< taken
    double msPerStep = 0;          ///< wall time of all steps over their number, building not counted [ms]
    std::vector<double> stepMs{};  ///< wall time of each step [ms]
    double busy = 1;               ///< processor time over wall time; below 1 others had the processor meanwhile [-]
    long peakKb = 0;               ///< the most memory the process had, the scene not counted once it is built [KiB]
    std::vector<Phase> phases{};   ///< where the time of a step went, mean of the run, as the engine tells it [s]
};

/// Runs in a process of its own, so that its memory is its own. steps: instead of the scene's.
/// Throws std::runtime_error when that process fails, saying how.
BenchRun measureRun(const std::function<Scene()>& scene, const Engine& engine, std::optional<int> steps = {});

}  // namespace plumb::compare
