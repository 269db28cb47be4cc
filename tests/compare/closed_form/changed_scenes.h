// SPDX-License-Identifier: MIT
// What is a scene like with one of its numbers 20 % smaller or larger?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

struct ChangedScene {
    std::string what;   ///< "mass", "friction", "restitution", "angle", "speed", "damping", "gravity"
    double factor = 1;  ///< [-]
    Scene scene;
};

/// Each number that the scene has, by 0.8 and by 1.2; a restitution of 1 by 0.8 only. The mass is that of the first
/// body of the closed form; what else it is, it is of all bodies. An angle is that of a slope, a swing or a shot.
std::vector<ChangedScene> changedScenes(const Scene& scene);

}  // namespace plumb::compare
