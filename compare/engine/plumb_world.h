// SPDX-License-Identifier: MIT
// How does a scene become a world of Plumb?
#pragma once
#include <vector>

#include <compare/scene/joint_geometry.h>
#include <plumb/dynamics/world.h>

namespace plumb::compare {

/// Bodies and joints are in the scene's order.
struct PlumbWorld {
    World world;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    std::vector<JointGeometry> geometries;
};

/// Adds one of the scene's bodies or joints to the world, and puts its id at its place in the list.
void putBody(PlumbWorld& made, const Scene& scene, std::size_t body);
void putJoint(PlumbWorld& made, const JointGeometry& geometry, std::size_t joint);

/// A world with the bodies and joints that are there at the start of the scene; the ids of the others are empty.
/// Gravity, sleeping and wrapping come from the scene, everything else from def.
PlumbWorld plumbWorld(const Scene& scene, WorldDef def = {});

}  // namespace plumb::compare
