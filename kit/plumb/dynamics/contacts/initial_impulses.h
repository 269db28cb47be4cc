// SPDX-License-Identifier: MIT
// What will new contacts have to bear? The solver warm starts with what they bore in the step before; these have none.
#pragma once
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

/// Gives each lane that touches and has no impulse yet those that hold its two bodies against their accelerations over
/// half a sub-step, as if they were alone. Without, the first sweeps turn what only just begins to tip.
/// Test: "a block that begins to tip turns as its formula says from the first step on"
/// lanes: of the solver (see SolverSettings).
void guessImpulses(ContactBatch& batch, const BodyStore& bodies, int lanes);

}  // namespace plumb
