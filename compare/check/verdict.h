// SPDX-License-Identifier: MIT
// What came of a scene's checks?
#pragma once
#include <algorithm>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <vector>

#include <compare/check/horizon.h>
#include <compare/metric/metrics.h>
#include <compare/parting/parting.h>

namespace plumb::compare {

/// In this order, so that the verdict on several scenes or labs is the largest of theirs: it fails if one fails, and
/// holds if one was judged and none fails.
enum class Verdict { NotJudged, Holds, Fails };

/// As JSON has it: true, false, or null for what was not judged. The JSON library calls it by this name.
template <class Json>
void to_json(Json& json, Verdict verdict) {
    json = verdict == Verdict::NotJudged ? Json(nullptr) : Json(verdict == Verdict::Holds);
}

/// The verdict on a list of outcomes, each with a pass. An empty list was not judged.
template <class Outcomes>
Verdict verdictOf(const Outcomes& outcomes) {
    if (std::ranges::empty(outcomes)) return Verdict::NotJudged;
    const bool pass = std::ranges::all_of(outcomes, [](const auto& outcome) { return outcome.pass; });
    return pass ? Verdict::Holds : Verdict::Fails;
}

/// The largest verdict of scenes or of labs. An empty list was not judged.
template <class Results>
Verdict overallVerdict(const Results& results) {
    Verdict verdict = Verdict::NotJudged;
    for (const auto& result : results) verdict = std::max(verdict, result.verdict);
    return verdict;
}

/// One check on one engine.
struct Outcome {
    std::string check;            ///< "exact", "agree", "invariant", "order"
    std::string engine;           ///< whom it binds
    std::string metric;           ///< what was looked at; "order" for an observed order of convergence
    std::optional<double> value;  ///< empty where it does not exist
    double limit = 0;             ///< the value is at most this; an order is at least this
    bool pass = false;
    std::string reason;     ///< why this limit, from the scene
    std::string missing{};  ///< why there is no value, where that is known
};

struct EngineResult {
    Observation observation;
    Measured measured;
    std::string answer{};  ///< to the scene's question: see answer.h
    OwnSteps ownSteps{};   ///< if asked for: see RunOptions::inDetail
};

struct SceneResult {
    Scene scene;                        ///< as it was run: dt and duration are those of the options where these say so
    std::vector<EngineResult> engines;  ///< in the order of engines()
    std::vector<Outcome> outcomes;      ///< empty where no check binds an engine that was run
    std::vector<Parting> partings;      ///< of each two engines that ran it, in their order
    Verdict verdict = Verdict::NotJudged;
    std::vector<std::string> changed{};  ///< what was set, as "bodies.ball.velocity = 15,26"; empty: as it is built in
    /// Metrics of checks that were not judged, because they expect what holds for the scene as it was before.
    std::vector<std::string> unjudged{};
};

struct RunOptions {
    std::vector<std::string> engines;    ///< names; empty: all. The closed form is always run for measuring.
    std::optional<int> steps;            ///< instead of the scene's
    std::optional<double> dt;            ///< instead of the scene's [s]
    std::vector<std::string> changed{};  ///< what was set in the scene before, for SceneResult::changed
    bool inDetail = false;               ///< also what takes longer: EngineResult::ownSteps, and Parting::portions
};

/// Runs a scene in the engines, measures, and judges every check that binds an engine that was run:
///   exact      the subject's error_max is at most the limit; and at most 1 mm or the best peer's, where one was run
///   agree      divergence_max up to the horizon, for each peer that was run beside the subject
///   invariant  the metric, for each of the check's engines; the subject where it names none
///   order      the smaller of log2(e(dt) / e(dt/2)) and log2(e(dt/2) / e(dt/4)), where e is error_max. An error of at
///              most 1e-12 of the scene's size (at least 1 m) is rounding and does not fall: no ratio starts from it.
///              Where no ratio is left, the value is empty and the check holds.
/// Where fields were set, a probe is judged only if the closed form says what to expect of it.
/// An engine is not judged when it is not among the given ones, was not asked for, or cannot build the scene. The
/// subject must be able to build it. Where a value does not exist, the check fails: a probe that is watched only after
/// a shortened run has ended, or a settling that never came.
/// Throws std::invalid_argument when the options name an engine that is not among the given ones or have steps below 1,
/// and as validate does for the scene that they make.
SceneResult runScene(const Scene& scene, const RunOptions& options, const std::vector<Engine>& engines);

/// The same for runs of a valid scene that were observed before; their engines are among the given ones.
SceneResult resultOf(const Scene& scene, std::vector<Observation> observed, const RunOptions& options,
                     const std::vector<Engine>& engines);

/// The outcomes of the scene's checks, in their order, as runScene describes them. The engines are those to run anew
/// with smaller steps for the order of convergence.
std::vector<Outcome> judge(const SceneResult& measured, const std::vector<Engine>& engines);

/// The metrics of probes that expect a number which the scene's author worked out for the scene as it was written: they
/// say nothing of a scene in which something was set. truth: the run of the closed form.
std::vector<std::string> metricsOfItsNumbers(const Scene& scene, const Observation& truth);

/// The order that errors at dt, dt/2, dt/4, ... show: the smallest log2 of the ratio of one to the next. Errors up to
/// floor are rounding; empty when there is no ratio that starts above it.
std::optional<double> observedOrder(std::span<const double> errors, double floor);

}  // namespace plumb::compare
