// SPDX-License-Identifier: MIT
// What does a run answer to a scene's question?
#pragma once
#include <optional>
#include <string>

#include <compare/metric/metrics.h>
#include <compare/metric/observation.h>
#include <compare/scene/answer.h>

namespace plumb::compare {

/// The query is not one of a metric, and the run has states. Lengths and times as SI, angles in degrees. None if what
/// it names does not happen in the run.
std::optional<double> valueOf(const Scene& scene, const Observation& run, const AnswerQuery& query);

/// "m", "s", "deg", or a probe's own unit.
std::string unitOf(const Scene& scene, const AnswerQuery& query);

/// "5 m", "36.2 deg", "–": to three digits.
std::string valueText(double value, const std::string& unit);

/// The scene's answer with the numbers of a run, to three digits and with their units; "–" where there is no number.
/// Empty where the scene has no answer or the engine did not run it. Lengths and times as SI, angles in degrees.
std::string answerOf(const Scene& scene, const Observation& run, const Measured& measured);

}  // namespace plumb::compare
