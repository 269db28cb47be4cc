// SPDX-License-Identifier: MIT
// How long does an engine take for a scene, and how much memory?
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <compare/bench/integrity.h>
#include <compare/engine/engine.h>

namespace plumb::compare {

/// One run of one scene in one engine.
struct BenchRun {
    std::string unsupported{};     ///< why the engine could not build the scene; empty when it could
    std::string question{};        ///< the scene's
    std::size_t bodies = 0;        ///< of the scene
    std::size_t joints = 0;        ///< likewise
    int steps = 0;                 ///< taken
    double msPerStep = 0;          ///< processor time of all steps over their number, building not counted [ms]
    std::vector<double> stepMs{};  ///< processor time of each step [ms]
    double busy = 1;               ///< processor time over wall time; below 1 others had the processor meanwhile [-]
    long peakKb = 0;               ///< the most memory the process had, the scene not counted once it is built [KiB]
    std::vector<Phase> phases{};   ///< where the time of a step went, mean of the run, as the engine tells it [s]
    std::optional<Integrity> integrity{};  ///< where it was looked at

    double seconds() const { return msPerStep * steps / 1000; }  ///< processor time of all steps [s]
};

struct MeasureOptions {
    std::optional<int> steps{};  ///< instead of the scene's
    bool look = false;           ///< at whether the scene still does what it should, at 32 steps spread over the run
};

/// Runs in a process of its own, so that its memory and its processor time are its own.
/// Throws std::runtime_error when that process fails, saying how.
BenchRun measureRun(const std::function<Scene()>& scene, const Engine& engine, const MeasureOptions& options = {});

}  // namespace plumb::compare
