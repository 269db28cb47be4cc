// SPDX-License-Identifier: MIT
// How far is a watched quantity from what is expected?
#pragma once
#include <compare/metric/observation.h>

namespace plumb::compare {

/// The largest distance from what is expected, from probe.from to probe.until, of the values that probe.watch counts.
/// Expected is probe.expected; for an angle of a body that has a closed form at probe.from, the closed form's angle as
/// long as it holds. Infinite where a value is not a number. Empty when nothing was watched: the run ends before
/// probe.from, or the engine does not know the value.
std::optional<double> probeError(const Scene& scene, std::size_t probe, const Observation& run,
                                 const Observation* truth);

}  // namespace plumb::compare
