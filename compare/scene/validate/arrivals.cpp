// SPDX-License-Identifier: MIT
#include <compare/scene/validate/parts.h>

#include <algorithm>

#include <compare/scene/named.h>
#include <plumb/math/check.h>

namespace plumb::compare {
namespace {

void validateTimes(const Scene& scene, std::size_t index) {
    const SceneBody& body = scene.bodies[index];
    const std::string field = at("bodies", index);
    requireNotNegative(body.appears, field, ".appears");
    requireNotNegative(body.renewed, field, ".renewed");
    if (body.renewed > 0 && body.renewed < scene.dt)
        refuse(field + ".renewed", toText(body.renewed) + " is shorter than a step, " + toText(scene.dt) + " s");
}

/// Gears are refused here: they couple joints, which may appear at different times.
void validateTogether(const Scene& scene, std::size_t index, const NameIndex& bodies) {
    const SceneJoint& joint = scene.joints[index];
    const auto a = bodies.find(joint.bodyA), b = bodies.find(joint.bodyB);
    const std::string field = at("joints", index);
    if (std::holds_alternative<GearJointDef>(joint.def))
        refuse(field, quoted(joint.name) + " is a gear, wanted none where bodies appear later");
    if (!a || !b) return;
    const SceneBody &first = scene.bodies[*a], &second = scene.bodies[*b];
    const bool together = first.appears == second.appears && first.renewed == second.renewed;
    if (!together && !isAlwaysThere(first) && !isAlwaysThere(second))
        refuse(field + ".bodyB", quoted(joint.bodyB) + " does not appear with " + quoted(joint.bodyA) +
                                     ", wanted both together, or one always there");
}

}  // namespace

void validateArrivals(const Scene& scene, const NameIndex& bodies) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) validateTimes(scene, i);
    const auto late = std::ranges::find_if_not(scene.bodies, isAlwaysThere);
    if (late == scene.bodies.end()) return;
    const auto refuseAny = [&](const auto& list, const std::string& name) {
        if (!list.empty()) refuse(name, "there are some, wanted none where bodies appear later: " + quoted(late->name));
    };
    refuseAny(scene.probes, "probes");
    refuseAny(scene.fields, "fields");
    if (scene.closedForm) refuse("closedForm", "wanted none where bodies appear later: " + quoted(late->name));
    if (scene.wrap.any()) refuse("wrap", "wanted none where bodies appear later: " + quoted(late->name));
    for (const SceneMover& mover : scene.movers)
        if (const auto body = bodies.find(mover.body); body && !isAlwaysThere(scene.bodies[*body]))
            refuse("movers", quoted(mover.body) + " appears later, wanted a body that is always there");
    for (std::size_t i = 0; i < scene.joints.size(); ++i) validateTogether(scene, i, bodies);
}

}  // namespace plumb::compare
