// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

// The scissor lift: stages of two crossed bars.
constexpr int stages = 4;
constexpr double bar = 2;           // the length of a bar [m]
constexpr double start = 1.8;       // distance between the feet at the start [m]
constexpr double drawSpeed = 0.25;  // speed at which the feet are pulled together [m/s]

double risePerStage(double feet) {
    return std::sqrt(bar * bar - feet * feet);
}

SceneBody ghost(const std::string& name, const Vec2& position, double angle, const ShapeDef& shape, double mass) {
    SceneBody body{name, {.position = position, .angle = angle, .canSleep = false, .shapes = {shape}}};
    body.def.shapes[0].filter.mask = 0;
    body.def.mass = Mass{mass, {0, 0}, mass * bar * bar / 12};
    return body;
}

/// Two crossed bars of 2 kg, from (0, low) and (start, low), with a hinge in their middle.
void addStage(Scene& scene, int stage) {
    const double rise = risePerStage(start), angle = arcTangent(rise, start);
    const Vec2 middle(start / 2, rise * (stage + 0.5));
    const std::string number = std::to_string(stage + 1);
    const ShapeDef shape = box({bar / 2, 0.03});
    scene.bodies.push_back(ghost("up_" + number, middle, angle, shape, 2));
    scene.bodies.push_back(ghost("down_" + number, middle, -angle, shape, 2));
    hinge(scene, "cross_" + number, "up_" + number, "down_" + number, middle);
    if (stage == 0) return;
    const std::string below = std::to_string(stage);
    hinge(scene, "left_" + number, "down_" + below, "up_" + number, {0, rise * stage});
    hinge(scene, "right_" + number, "up_" + below, "down_" + number, {start, rise * stage});
}

/// A wheel with a given moment of inertia on an axle in the wall, free to turn.
void addWheel(Scene& scene, const std::string& name, const Vec2& position, double radius, double inertia) {
    SceneBody wheel{name, {.position = position, .canSleep = false, .shapes = {circle(radius)}}};
    wheel.def.shapes[0].filter.mask = 0;
    wheel.def.mass = Mass{1, {0, 0}, inertia};
    scene.bodies.push_back(wheel);
    hinge(scene, "axle_of_" + name, "pivot", name, position);
}

void addGear(Scene& scene, const std::string& a, const std::string& b, double ratio) {
    scene.joints.push_back({.name = a + "_to_" + b, .def = GearJointDef{.ratio = ratio}, .jointA = a, .jointB = b});
}

}  // namespace

Scene scissorLift() {
    Scene scene{
        .name = "scissor_lift",
        .question = "Four stages of crossed bars are drawn together at the foot: how high do they lift 10 kg?",
        .duration = 3,
        .bodies = {pivotBody({0, 0})},
    };
    for (int stage = 0; stage < stages; ++stage) addStage(scene, stage);
    const double top = stages * risePerStage(start);
    scene.bodies.push_back(ghost("foot", {start, 0}, 0, box({0.1, 0.05}), 2));
    scene.bodies.push_back(ghost("slide", {start, top}, 0, box({0.1, 0.05}), 2));
    scene.bodies.push_back(ghost("platform", {0, top}, 0, box({1, 0.05}), 10));
    hinge(scene, "pin", "pivot", "up_1", {0, 0});
    hinge(scene, "foot_pin", "foot", "down_1", {start, 0});
    hinge(scene, "top_pin", "down_4", "platform", {0, top});
    hinge(scene, "slide_pin", "up_4", "slide", {start, top});
    scene.joints.push_back(
        {"rail", "pivot", "foot",
         PrismaticJointDef{
             .anchor = {start, 0}, .axis = {-1, 0}, .motorSpeed = drawSpeed, .maxMotorForce = unlimited}});
    scene.joints.push_back({"top_rail", "platform", "slide", PrismaticJointDef{.anchor = {start, top}}});
    const double height = stages * risePerStage(start - drawSpeed * scene.duration);
    scene.probes = {{.name = "height",
                     .quantity = PositionProbe{"platform", {0, 1}},
                     .expected = height,
                     .unit = "m",
                     .watch = Watch::Last},
                    {.name = "drift", .quantity = PositionProbe{"platform", {1, 0}}, .expected = 0, .unit = "m"},
                    {.name = "tilt", .quantity = AngleProbe{"platform"}, .expected = 0, .unit = "rad"}};
    scene.checks = {
        invariant("probe.height", 5e-3,
                  "n sqrt(l^2 - x^2); the feet are half a sub-step's way off, 0.5 mm, which lifts 5 times it"),
        invariant("probe.drift", 1e-3, "the left pins stay over each other"),
        invariant("probe.tilt", 1e-3, "the two rails stay level"),
        invariant("joint_error_max", 1e-3, "nobody sees an error of 1 mm in 2 m"),
    };
    return scene;
}

Scene gearTrain() {
    // A motor of 6 N m turns wheel 1. Wheel 1 drives wheel 2, wheel 2 drives wheel 3, and wheel 3 drives a rack.
    const double torque = 6, ratios[] = {2, -0.5}, rackMass = 4, pinion = 0.25;
    const double inertias[] = {0.5, 2, 1};
    Scene scene{.name = "gear_train",
                .question = "A motor drives three wheels and a rack through gears: how fast do they gain speed?",
                .gravity = {0, 0},
                .duration = 2,
                .bodies = {pivotBody({0, -2})},
                .closedForm = ClosedForm{.formula = "a1 = M / (I1 + I2 r2^2 + I3 r3^2 + m x^2), a_i = r_i a1",
                                         .source = "textbook: virtual work"}};
    addWheel(scene, "wheel_1", {-1.5, 0}, 0.5, inertias[0]);
    addWheel(scene, "wheel_2", {0, 0}, 1, inertias[1]);
    addWheel(scene, "wheel_3", {1.5, 0}, 0.5, inertias[2]);
    scene.bodies.push_back(ghost("rack", {2.5, 0.5}, 0, box({0.5, 0.05}), rackMass));
    auto& motor = std::get<RevoluteJointDef>(scene.joints[0].def);
    motor.motorSpeed = 1e4;
    motor.maxMotorTorque = torque;
    scene.joints.push_back({"guide", "pivot", "rack", PrismaticJointDef{.anchor = {2.5, 0.5}}});
    addGear(scene, "axle_of_wheel_1", "axle_of_wheel_2", ratios[0]);
    addGear(scene, "axle_of_wheel_2", "axle_of_wheel_3", ratios[1]);
    addGear(scene, "axle_of_wheel_3", "guide", -1 / pinion);
    for (std::size_t i = 0; i < 3; ++i) {
        const SceneBody& wheel = scene.bodies[i + 1];
        scene.closedForm->bodies.push_back(GearedMotion{wheel.name, "axle_of_" + wheel.name});
        scene.probes.push_back({.name = wheel.name, .quantity = AngleProbe{wheel.name}, .unit = "rad"});
        scene.checks.push_back(invariant("probe." + wheel.name, 1e-3, "a constant torque: second order is exact"));
    }
    scene.closedForm->bodies.push_back(GearedMotion{"rack", "guide"});
    scene.checks.push_back(
        ExactCheck{1e-3, "a constant torque: second order is exact; what is left is single precision"});
    scene.checks.push_back(invariant("joint_error_max", 1e-4, "nobody sees an error of 0.1 mm"));
    return scene;
}

}  // namespace plumb::compare
