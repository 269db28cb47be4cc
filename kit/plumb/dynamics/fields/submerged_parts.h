// SPDX-License-Identifier: MIT
// Which parts of a body are under water?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/space/space.h>

namespace plumb {

/// The part of each of its shapes that is, if there is one; the body is where motion says.
std::vector<Submerged> submergedPartsOf(const BodyStore& bodies, const Space& space, BodyIndex body,
                                        const BodyMotion& motion, const Fluid& fluid);

}  // namespace plumb
