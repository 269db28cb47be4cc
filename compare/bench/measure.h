// SPDX-License-Identifier: MIT
// How much time and memory does an engine need for a scene?
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
    std::size_t joints = 0;        ///< of the scene
    int steps = 0;                 ///< taken
    double msPerStep = 0;          ///< processor time of all steps divided by their number, without building [ms]
    std::vector<double> stepMs{};  ///< processor time of each step [ms]
    double busy = 1;               ///< processor time / wall time; below 1, others used the processor too [-]
    long peakKb = 0;               ///< the process's most memory; the scene does not count once it is built [KiB]
    std::vector<Phase> phases{};   ///< time of each part of a step, mean of the run, as the engine reports it [s]
    std::optional<Integrity> integrity{};  ///< empty if the run was not looked at

    double seconds() const { return msPerStep * steps / 1000; }  ///< processor time of all steps [s]
};

struct MeasureOptions {
    std::optional<int> steps{};  ///< instead of the scene's
    bool look = false;           ///< check at 32 steps, spread over the run, that the scene still does what it should
};

/// The run has a separate process, so that its memory and processor time can be measured. Throws std::runtime_error if
/// that process fails, and says how.
BenchRun measureRun(const std::function<Scene()>& scene, const Engine& engine, const MeasureOptions& options = {});

}  // namespace plumb::compare
