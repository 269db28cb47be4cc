// SPDX-License-Identifier: MIT
// What does a run answer to a scene's question?
#pragma once
#include <string>

#include <compare/metric/metrics.h>

namespace plumb::compare {

/// The scene's answer with the numbers of a run, to three digits and with their units; "–" where there is no number.
/// Empty where the scene has no answer or the engine did not run it. Lengths and times as SI, angles in degrees.
std::string answerOf(const Scene& scene, const Observation& run, const Measured& measured);

}  // namespace plumb::compare
