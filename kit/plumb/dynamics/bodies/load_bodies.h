// SPDX-License-Identifier: MIT
// What do the hot loops need to know of each body for this step?
#pragma once
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// Puts the state of every awake body into the floats of narrow phase and solver, for a step of dt [s]. A body that is
/// out of range is marked for quarantine and left at rest.
void loadBodies(BodyStore& bodies, double dt);
/// The same for one body that woke up within the step.
void loadBody(BodyStore& bodies, BodyIndex body, double dt);

}  // namespace plumb
