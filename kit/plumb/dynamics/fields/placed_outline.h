// SPDX-License-Identifier: MIT
// Which outline does a shape have in the world, and which part of it is under water?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/shapes/shape.h>
#include <plumb/space/detail/space.h>

namespace plumb {

struct PlacedOutline {
    StepList<Vec2> corners;  ///< in the world [m]
    double radius = 0;       ///< rounding radius: the outline lies this far outside the corners [m]
    bool hasArea = false;
};

/// The outline of a shape on a body that is in the state `there`.
PlacedOutline placedOutline(const Shape& shape, const BodyRecord& body, const BodyMotion& there);

/// The submerged part of each of the body's shapes that has one. The body's position is that of motion.
StepList<Submerged> submergedPartsOf(const BodyStore& bodies, const Space& space, BodyIndex body,
                                     const BodyMotion& motion, const Fluid& fluid);

}  // namespace plumb
