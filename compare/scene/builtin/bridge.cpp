// SPDX-License-Identifier: MIT
#include <compare/formula/catenary.h>
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

const HungChain shape{.left = {-4.9, 0}, .span = 9.8, .links = 20, .linkLength = 0.5};

/// Twenty planks of 2 kg over a gap of 9.8 m. Damping lets the swinging die away.
Scene bridge() {
    Scene scene{.bodies = {pivotBody({0, 0})}};
    const std::vector<Vec2> hinges = hingesOf(shape);
    addLinks(scene, {.hinges = hinges, .halfWidth = 0.05, .linkMass = 2, .solid = true, .damping = 1});
    holdEnds(scene, hinges);
    return scene;
}

/// A box of 0.5 m above the bridge.
SceneBody load(const std::string& name, const Vec2& position, double mass) {
    return {name,
            {.position = position,
             .linearDamping = 1,
             .shapes = {box({0.25, 0.25}, {.density = mass / 0.25, .friction = 0.8})}}};
}

}  // namespace

Scene bridgeUnderLoad() {
    Scene scene = bridge();
    scene.name = "bridge_under_load";
    scene.question = "Does a bridge of twenty planks of 2 kg hold three boxes of 20 kg, and come to rest?";
    scene.duration = 10;
    for (int i = 0; i < 3; ++i) scene.bodies.push_back(load("box_" + std::to_string(i + 1), {0.8 * (i - 1), -0.3}, 20));
    scene.checks = {
        invariant("joint_error_max", 1e-3, "nobody sees an error of 1 mm on a plank of 50 cm"),
        invariant("penetration_max", 1e-2, "boxes fall 0.2 m onto the planks, and weigh ten times as much"),
        invariant("settle_time", 9, "in nine seconds the air lets the swing shrink to e^-4.5"),
    };
    return scene;
}

Scene breakingBridge() {
    Scene scene = bridge();
    scene.name = "breaking_bridge";
    scene.question = "Does a bridge hold 20 kg, and break where it is weak when 200 kg follow?";
    scene.duration = 5;
    SceneJoint& weak = scene.joints.at(9);
    weak.name = "weak";
    std::get<RevoluteJointDef>(weak.def).breaking.force = 4000;
    scene.bodies.push_back(load("light", {-0.6, -0.45}, 20));
    scene.bodies.push_back(load("heavy", {0.6, 2}, 200));
    scene.bodies.back().def.velocity = {0, 7};  // up first, so that it falls later
    const Probe broken{
        .name = "broken", .quantity = JointBrokenProbe{"weak"}, .expected = 1, .unit = "-", .watch = Watch::Last};
    Probe holds = broken;
    holds.name = "holds";
    holds.expected = 0;
    holds.until = 1.5;
    scene.probes = {broken, holds};
    scene.checks = {
        invariant("probe.holds", 0, "bridge and light box pull on it with W L / (8 s) + w L / (4 s) = 1.1 kN"),
        invariant("probe.broken", 0, "200 kg, at rest in its middle, would pull on it with 5.6 kN more"),
        invariant("joint_error_max", 1e-2, "for the hinges that hold when 200 kg hit planks of 2 kg at 10 m/s"),
    };
    return scene;
}

}  // namespace plumb::compare
