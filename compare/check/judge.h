// SPDX-License-Identifier: MIT
// Which of a scene's checks hold for what was measured?
#pragma once
#include <span>
#include <vector>

#include <compare/check/verdict.h>

namespace plumb::compare {

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
