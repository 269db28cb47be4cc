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

std::string titleOf(const Scene& scene) {
    if (!scene.title.empty()) return scene.title;
    std::string title = scene.name;
    std::ranges::replace(title, '_', ' ');
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

int stepCount(const Scene& scene) {
    return static_cast<int>(std::lround(scene.duration / scene.dt));
}

}  // namespace plumb::compare
