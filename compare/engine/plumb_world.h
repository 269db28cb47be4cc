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

PlumbWorld plumbWorld(const Scene& scene, const SolverSettings& solver = {});

}  // namespace plumb::compare
