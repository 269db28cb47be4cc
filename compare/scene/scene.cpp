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

std::vector<std::string> checkableMetrics(const Scene& scene) {
    std::vector<std::string> names{
        "divergence_max",  "divergence_time", "energy_drift", "momentum_drift", "angular_momentum_drift",
        "penetration_max", "joint_error_max", "settle_time",  "ms_per_step"};
    if (scene.closedForm) names.insert(names.end(), {"error_max", "error_end"});
    for (const Probe& probe : scene.probes) names.push_back("probe." + probe.name);
    return names;
}

}  // namespace plumb::compare
