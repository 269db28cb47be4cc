// SPDX-License-Identifier: MIT
// Which parts of a body are under water?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The submerged part of each of the body's shapes that has one. The body's position is that of motion.
std::vector<Submerged> submergedPartsOf(const BodyStore& bodies, const Space& space, BodyIndex body,
                                        const BodyMotion& motion, const Fluid& fluid);

}  // namespace plumb
