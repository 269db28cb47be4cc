// SPDX-License-Identifier: MIT
// Where will two shapes touch that are still separated, but may meet during the step?
#pragma once
#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

/// The pose of B in the frame of A, both frames with their origin in the body's centre of mass.
RelativePose relativePose(const BodyMotion& a, const BodyMotion& b);

/// The manifold of two shapes at the time when they first meet in this step, transformed back to the step's start;
/// empty if they do not meet. The manifold at the step's start would be wrong for distant shapes: a body that passes a
/// corner would be stopped by the plane of a face that it never touches. Separations are at most margin [m].
Manifold predictedManifold(const BodyStore& bodies, const Space& space, const ShapePair& pair, float margin, double dt);

}  // namespace plumb
