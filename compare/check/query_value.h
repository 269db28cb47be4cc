// SPDX-License-Identifier: MIT
// Which number does a query find in a run?
#pragma once
#include <optional>
#include <string>

#include <compare/metric/observation.h>
#include <compare/scene/answer.h>

namespace plumb::compare {

/// The query is not one of a metric, and the run has states. Lengths and times as SI, angles in degrees. None if what
/// it names does not happen in the run.
std::optional<double> valueOf(const Scene& scene, const Observation& run, const AnswerQuery& query);

/// "m", "s", "deg", or a probe's own unit.
std::string unitOf(const Scene& scene, const AnswerQuery& query);

}  // namespace plumb::compare
