// SPDX-License-Identifier: MIT
#include <compare/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace plumb::compare {

bool bounces(const Scene& scene) {
    const auto shapeBounces = [](const ShapeDef& shape) { return shape.material.restitution > 0; };
    return std::ranges::any_of(
        scene.bodies, [&](const SceneBody& body) { return std::ranges::any_of(body.def.shapes, shapeBounces); });
}

int stepCount(const Scene& scene) {
    return static_cast<int>(std::lround(scene.duration / scene.dt));
}

}  // namespace plumb::compare
