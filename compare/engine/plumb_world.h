// SPDX-License-Identifier: MIT
// Which world of Plumb is a scene?
#pragma once
#include <vector>

#include <compare/engine/joint_geometry.h>
#include <plumb/dynamics/world.h>

namespace plumb::compare {

/// Bodies and joints are in the scene's order.
struct PlumbWorld {
    World world;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
};

/// Puts one of the scene's bodies in, or one of its joints, in its place in the list.
void putBody(PlumbWorld& made, const Scene& scene, std::size_t body);
void putJoint(PlumbWorld& made, const JointGeometry& geometry, std::size_t joint);

/// With what is there at the start of the scene; of the rest the ids are empty. The scene says which gravity there is,
/// and whether what rests may sleep; the rest is as given.
PlumbWorld plumbWorld(const Scene& scene, WorldDef def = {});

}  // namespace plumb::compare
