// SPDX-License-Identifier: MIT
// Which world of Plumb is a scene?
#pragma once
#include <vector>

#include <compare/scene/scene.h>
#include <plumb/dynamics/world.h>

namespace plumb::compare {

/// Bodies and joints are in the scene's order.
struct PlumbWorld {
    World world;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
};

/// The scene says which gravity there is, and whether what rests may sleep; the rest is as given.
PlumbWorld plumbWorld(const Scene& scene, WorldDef def = {});

}  // namespace plumb::compare
