// SPDX-License-Identifier: MIT
#include "compare/parting/planted.h"

#include <cmath>

namespace plumb::compare {
namespace {

constexpr const char* subject = "plumb";
constexpr const char* other = "box2d-2.4";
constexpr const char* further = "chipmunk";

SceneBody fixedBox(const std::string& name, const Vec2& position, const Vec2& halfSize, double friction = 0.5) {
    return {name, {.type = BodyType::Static, .position = position, .shapes = {box(halfSize, {.friction = friction})}}};
}

SceneBody looseBox(const std::string& name, const Vec2& position, const Vec2& halfSize, double density = 1) {
    return {name, {.position = position, .shapes = {box(halfSize, {.density = density, .friction = 0.5})}}};
}

SceneBody looseDisc(const std::string& name, const Vec2& position, const Vec2& velocity,
                    const Material& material = {.friction = 0}) {
    return {name, {.position = position, .velocity = velocity, .shapes = {circle(0.5, material)}}};
}

Scene weightless(const std::string& name, double duration, std::vector<SceneBody> bodies) {
    return {.name = name, .gravity = {0, 0}, .duration = duration, .bodies = std::move(bodies)};
}

SceneJoint hinge(const std::string& name, const std::string& a, const std::string& b, const Vec2& anchor) {
    return {name, a, b, RevoluteJointDef{.anchor = anchor}};
}

/// Five links, and 1,000 times the density at the end of them.
Planted stretchingHinge() {
    Scene scene{.name = "stretching_hinge", .duration = 1, .bodies = {fixedBox("post", {0, 0}, {0.1, 0.1})}};
    for (int i = 0; i < 5; ++i) {
        const std::string link = "link_" + std::to_string(i);
        const std::string before = i == 0 ? "post" : "link_" + std::to_string(i - 1);
        scene.bodies.push_back(looseBox(link, {0.5 + i, 0}, {0.4, 0.05}));
        scene.joints.push_back(hinge("hinge_" + std::to_string(i), before, link, {1.0 * i, 0}));
    }
    scene.bodies.push_back(looseBox("load", {5.3, 0}, {0.3, 0.3}, 1000));
    scene.joints.push_back(hinge("hinge_load", "link_4", "load", {5, 0}));
    return {subject, other, scene, Difference::Gap, "link_0", "hinge_", 0.05, 0.2};
}

/// 0.8 m/s against a wall 1 m ahead of its rim.
Planted restitutionThreshold() {
    Scene scene = weightless(
        "restitution_threshold", 3,
        {fixedBox("wall", {2, 0}, {0.5, 2}), looseDisc("ball", {0, 0}, {0.8, 0}, {.friction = 0, .restitution = 1})});
    scene.engines[other]["solver.restitutionThreshold"] = "1";
    return {subject, other, scene, Difference::Bounce, "ball", "ball, wall", 1.25, 1.35};
}

/// Of thirty flush boxes the eighth stands 1 cm higher in one engine.
Planted snag() {
    Scene scene{.name = "snag", .duration = 2};
    for (int i = 0; i < 30; ++i)
        scene.bodies.push_back(fixedBox("tile_" + std::to_string(i), {1.0 * i, -0.5}, {0.5, 0.5}, 0));
    scene.bodies.push_back({"crate",
                            {.position = {0.3, 0.5},
                             .velocity = {6, 0},
                             .fixedRotation = true,
                             .shapes = {box({0.5, 0.5}, {.friction = 0})}}});
    scene.engines[further]["bodies.tile_8.position"] = "[8, -0.4]";
    return {subject, further, scene, Difference::Snag, "crate", "crate, tile_8", 1, 1.3};
}

/// 100 m/s, 1.67 m a step, against 10 cm that nothing holds.
Planted tunnelling() {
    SceneBody shot = looseDisc("shot", {0, 0}, {100, 0});
    shot.def.shapes = {circle(0.05)};
    return {subject,
            other,
            weightless("tunnelling", 0.5, {looseBox("board", {5, 0}, {0.05, 2}, 10), shot}),
            Difference::Passed,
            "shot",
            "shot, board",
            0.04,
            0.09};
}

Planted sinkingStack() {
    Scene scene{.name = "sinking_stack", .duration = 2, .bodies = {fixedBox("floor", {0, -0.5}, {20, 0.5})}};
    for (int i = 0; i < 4; ++i) scene.bodies.push_back(looseBox("box_" + std::to_string(i), {0, 0.5 + i}, {0.5, 0.5}));
    scene.bodies.push_back(looseBox("load", {0, 4.5}, {0.5, 0.5}, 400));
    return {subject, further, scene, Difference::Overlap, "load", "box_", 0.03, 0.15};
}

Planted otherMass() {
    Scene scene = weightless("other_mass", 2, {looseDisc("left", {-2, 0}, {3, 0}), looseDisc("right", {2, 0}, {0, 0})});
    scene.engines[other]["bodies.right.density"] = "2";
    return {subject, other, scene, Difference::Hit, "right", "right, left", 1, 1.1};
}

Planted otherFriction() {
    SceneBody crate = looseBox("crate", {0, 0.5}, {0.5, 0.5});
    crate.def.velocity = {4, 0};
    Scene scene{
        .name = "other_friction", .duration = 2, .bodies = {fixedBox("floor", {0, -0.5}, {20, 0.5}), std::move(crate)}};
    scene.engines[further]["bodies.crate.friction"] = "0.1";
    return {subject, further, scene, Difference::Sliding, "crate", "crate, floor", 0.1, 0.4};
}

Planted otherDamping() {
    Scene scene = weightless("other_damping", 2, {looseDisc("puck", {0, 0}, {5, 1})});
    scene.engines[other]["bodies.puck.linearDamping"] = "0.1";
    return {subject, other, scene, Difference::Flight, "puck", "puck", 0.3, 1};
}

/// A rod that swings from level.
Planted fewerSubSteps() {
    Scene scene{.name = "fewer_sub_steps",
                .duration = 3,
                .bodies = {fixedBox("post", {0, 0}, {0.1, 0.1}), looseDisc("bob", {2, 0}, {0, 0})},
                .joints = {{"rod", "post", "bob", DistanceJointDef{.anchorA = {0, 0}, .anchorB = {2, 0}}}}};
    scene.engines[further]["solver.iterations"] = "1";
    return {subject, further, scene, Difference::Gap, "bob", "rod", 0.2, 1};
}

/// 200 m/s; at most 2 m a step.
Planted speedLimit() {
    return {subject,
            other,
            weightless("speed_limit", 1, {looseDisc("shot", {0, 0}, {200, 0})}),
            Difference::Flight,
            "shot",
            "shot",
            0.01,
            0.1};
}

Planted otherGravity() {
    Scene scene{.name = "other_gravity", .duration = 1, .bodies = {looseDisc("shot", {0, 0}, {2, 3})}};
    scene.engines[further]["bodies.shot.gravityScale"] = "0.5";
    return {subject, further, scene, Difference::Flight, "shot", "shot", 0.03, 0.2};
}

Planted otherRestitution() {
    Scene scene{.name = "other_restitution",
                .duration = 2,
                .bodies = {fixedBox("floor", {0, -0.5}, {20, 0.5}),
                           looseDisc("ball", {0, 2}, {0, 0}, {.friction = 0, .restitution = 0.8})}};
    scene.engines[further]["bodies.ball.restitution"] = "0.3";
    return {subject, further, scene, Difference::Bounce, "ball", "ball, floor", 0.53, 0.65};
}

/// One engine is a step late in free fall, and the other does not bounce.
Planted noBounceBesideLateFall() {
    Scene scene{.name = "no_bounce_beside_late_fall",
                .duration = 2,
                .bodies = {fixedBox("floor", {0, 0}, {5, 0.5}),
                           looseDisc("rubber", {0, 3}, {0, 0}, {.friction = 0, .restitution = 0.7})}};
    scene.engines[other]["solver.restitutionThreshold"] = "20";
    return {other, further, scene, Difference::Bounce, "rubber", "rubber, floor", 0.6, 0.8};
}

/// A disc that moves along an undamped spring.
Scene bobOnSpring(const std::string& name) {
    Scene scene = weightless(name, 3, {fixedBox("post", {0, 0}, {0.1, 0.1}), looseDisc("bob", {2, 0}, {1, 0})});
    scene.joints = {
        {"coil", "post", "bob", DistanceJointDef{.anchorA = {0, 0}, .anchorB = {2, 0}, .spring = Spring{20, 0}}}};
    return scene;
}

Planted dampedSpring() {
    Scene scene = bobOnSpring("damped_spring");
    scene.engines[other]["joints.coil.distance.spring.damping"] = "3";
    return {subject, other, scene, Difference::Pull, "bob", "coil", 0.03, 0.5};
}

Planted weakMotor() {
    Scene scene = weightless("weak_motor", 3, {fixedBox("hub", {0, 0}, {0.1, 0.1}), looseBox("arm", {1, 0}, {1, 0.1})});
    scene.joints = {{"drive", "hub", "arm", RevoluteJointDef{.anchor = {0, 0}, .motorSpeed = 2, .maxMotorTorque = 5}}};
    scene.engines[other]["joints.drive.revolute.maxMotorTorque"] = "1";
    return {subject, other, scene, Difference::Pull, "arm", "drive", 0.03, 0.3};
}

/// 4 kg on a hook that bears 60 N, and 30 N in one engine: 39 N hang on it.
Planted weakHook() {
    SceneJoint hook = hinge("hook", "post", "lamp", {0, 0});
    std::get<RevoluteJointDef>(hook.def).breaking.force = 60;
    Scene scene{.name = "weak_hook",
                .duration = 1,
                .bodies = {fixedBox("post", {0, 0}, {0.1, 0.1}), looseBox("lamp", {0, -1}, {1, 1})},
                .joints = {hook}};
    scene.engines[other]["joints.hook.revolute.breaking.force"] = "30";
    return {subject, other, scene, Difference::Break, "lamp", "hook", 0.03, 0.2};
}

/// A spring without a damper, which one engine damps by its way of stepping.
Planted springThatTires() {
    return {subject, other, bobOnSpring("spring_that_tires"), Difference::Energy, "bob", "bob", 0.03, 2};
}

/// Both have the speed of a throw; one adds it up before the place, and is g t dt / 2 too low.
Planted otherOrderOfSteps() {
    Scene scene{.name = "other_order_of_steps", .duration = 2, .bodies = {looseDisc("shot", {0, 0}, {10, 0})}};
    return {subject, further, scene, Difference::Steps, "shot", "shot", 0.1, 0.3};
}

Planted fasterLift() {
    SceneBody lift = fixedBox("lift", {0, 0}, {1, 0.1});
    lift.def.type = BodyType::Kinematic;
    lift.def.velocity = {0, 1};
    Scene scene{.name = "faster_lift", .duration = 1, .bodies = {lift}};
    scene.engines[further]["bodies.lift.velocity"] = "[0, 1.2]";
    return {subject, further, scene, Difference::Driven, "lift", "lift", 0.1, 0.4};
}

/// A smooth ramp, which in one engine is steeper by 0.05.
Planted steeperRamp() {
    constexpr double slope = 0.5;
    SceneBody ramp = fixedBox("ramp", {0, 0}, {20, 0.5}, 0);
    ramp.def.angle = -slope;
    const Vec2 start(std::sin(slope), std::cos(slope));  // it touches the middle of the ramp's upper side
    Scene scene{.name = "steeper_ramp", .duration = 1, .bodies = {ramp, looseDisc("ball", start, {0, 0})}};
    scene.engines[further]["bodies.ramp.angle"] = "-0.55";
    return {subject, further, scene, Difference::Pressing, "ball", "ball, ramp", 0.1, 0.8};
}

}  // namespace

std::vector<Planted> plantedScenes() {
    return {stretchingHinge(),
            restitutionThreshold(),
            snag(),
            tunnelling(),
            sinkingStack(),
            otherMass(),
            otherFriction(),
            otherDamping(),
            fewerSubSteps(),
            speedLimit(),
            otherGravity(),
            otherRestitution(),
            noBounceBesideLateFall(),
            dampedSpring(),
            weakMotor(),
            weakHook(),
            springThatTires(),
            otherOrderOfSteps(),
            fasterLift(),
            steeperRamp()};
}

}  // namespace plumb::compare
