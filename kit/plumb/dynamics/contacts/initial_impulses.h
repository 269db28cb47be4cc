// SPDX-License-Identifier: MIT
// Which load will new contacts carry? The solver warm-starts with the impulses of the last step; new contacts have
// none.
#pragma once
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

/// For each lane that touches and has no impulse yet, sets the impulses that hold its two bodies against their
/// accelerations during half a sub-step, as if the two were alone. Without this, the first sweeps of the solver turn a
/// body that only just begins to tip.
/// Test: "a block that begins to tip turns as its formula says from the first step on"
/// lanes: as in SolverSettings.
void guessImpulses(ContactBatch& batch, const BodyStore& bodies, int lanes);

}  // namespace plumb
