// SPDX-License-Identifier: MIT
// When within a step did a body hit something, and with what velocity?
#pragma once
#include <cstddef>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// A body at a moment of a run.
struct Sample {
    double time = 0;  ///< [s]
    BodyState state{};
};

/// The states of a body at the ticks, and two more at each impact within a step: just before it, and just after. An
/// impact is where the velocity jumps and does not in the steps beside. It lies where the flight before and the flight
/// after meet, each with the acceleration of the step beside it. Where they do not meet, nothing is added; nor for a
/// body that is moved tick by tick, whose velocity is that of its way in a tick.
std::vector<Sample> samplesOf(const Scene& scene, const Observation& run, std::size_t body);

}  // namespace plumb::compare
