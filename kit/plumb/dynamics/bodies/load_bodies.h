// SPDX-License-Identifier: MIT
// Which data of each body do the narrow phase and the solver need in this step?
#pragma once
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// Converts the state of a body to the floats of the narrow phase and the solver, for a step of dt [s]: at the start of
/// the step if it is awake, or as it wakes up. A body whose numbers are out of range is marked for quarantine and
/// treated as at rest.
void loadBody(BodyStore& bodies, BodyIndex body, double dt);

}  // namespace plumb
