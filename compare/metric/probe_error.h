// SPDX-License-Identifier: MIT
// How far is a watched quantity from what is expected?
#pragma once
#include <compare/metric/observation.h>

namespace plumb::compare {

/// The largest distance between probe.from and probe.until, of the values that probe.watch says. An angle whose body
/// has a closed form at the start of that is expected where that is, as long as it holds; anything else at
/// probe.expected. Infinite where what is seen is not a number. Empty when nothing was watched: the run ends before
/// probe.from, or the engine cannot say.
std::optional<double> probeError(const Scene& scene, std::size_t probe, const Observation& run,
                                 const Observation* truth);

}  // namespace plumb::compare
