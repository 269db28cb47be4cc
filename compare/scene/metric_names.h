// SPDX-License-Identifier: MIT
// Which metrics may a scene's checks name?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// error_max and error_end where there is a closed form, divergence_max, divergence_time, energy_drift, momentum_drift,
/// angular_momentum_drift, penetration_max, joint_error_max, settle_time, ms_per_step, and probe.<name> for each probe.
std::vector<std::string> checkableMetrics(const Scene& scene);

}  // namespace plumb::compare
