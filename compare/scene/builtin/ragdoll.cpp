// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/doll.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

const Vec2 neck(0.3, 4.4);  // where the doll stands: its toes are 1.4 m below its neck, 0.2 m above the top step

ShapeDef stairs() {
    constexpr int steps = 8;
    std::vector<Vec2> points{{10, 0}};
    for (int i = 0; i < steps; ++i) {
        const double x = 4 - 0.5 * i, y = 0.35 * i;
        points.push_back({x, y});
        points.push_back({x, y + 0.35});
    }
    points.push_back({-4, 0.35 * steps});
    return chain(points, {.friction = 0.4});  // from right to left: solid from above
}

}  // namespace

Scene ragdoll() {
    Scene scene{
        .name = "ragdoll",
        .question = "Does a doll that is pushed down the stairs hold together, bend no joint too far, and lie still?",
        .duration = 10,
        .bodies = {{"stairs", {.type = BodyType::Static, .shapes = {stairs()}}}}};
    addDoll(scene, {.neck = neck, .velocity = {2, 0}});
    for (const SceneJoint& joint : scene.joints) {
        const std::string probe = joint.bodyB + "_limit";
        scene.probes.push_back({.name = probe, .quantity = LimitProbe{joint.name}, .expected = 0, .unit = "rad"});
        scene.checks.push_back(invariant("probe." + probe, 0.05, "3 degrees, at a fall of 3 m"));
    }
    scene.checks.push_back(invariant("joint_error_max", 4e-2,
                                     "what a limb comes in a sub-step at 8 m/s, 3.3 cm, when the floor stops it"));
    scene.checks.push_back(invariant(
        "penetration_max", 2e-2, "less than the 3.3 cm that a limb moves in a sub-step, while its joints press on it"));
    scene.checks.push_back(invariant("settle_time", 9, "the stairs are only 2.8 m high; then friction stops the body"));
    return scene;
}

}  // namespace plumb::compare
