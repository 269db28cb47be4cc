// SPDX-License-Identifier: MIT
// Where will two shapes touch that are still apart, but may meet within the step?
#pragma once
#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

RelativePose relativePose(const BodyMotion& a, const BodyMotion& b);

/// The manifold of two shapes where and when they meet in this step, seen from the step's start; empty if they
/// do not meet. What flies past a corner is not to be held up by the face that it has before it from afar.
Manifold predictedManifold(const BodyStore& bodies, const Space& space, const ShapePair& pair, float margin, double dt);

}  // namespace plumb
