// SPDX-License-Identifier: MIT
#include <limits>
#include <numbers>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

/// Clockwise, so that a chain that is solid from one side only is solid from inside.
ShapeDef ring(const Vec2& center, double radius) {
    constexpr int count = 360;
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const SinCos turned = sinCos(-2 * std::numbers::pi * i / count);
        points.push_back(center + radius * Vec2(turned.cos, turned.sin));
    }
    return loop(points, {.friction = 0.1});
}

}  // namespace

Scene spinner() {
    constexpr int count = 6076, columns = 92;
    constexpr double spacing = 0.5;  // [m]
    const Vec2 axis(0, 12);
    Scene scene = benchScene("spinner", "What does a step of 6,076 bodies stirred in a ring take?", 500);
    scene.bodies.push_back(fixedBody("ground", {ring({0, 32}, 40)}));
    SceneBody paddle{"paddle", {.position = axis, .shapes = {roundedBox({0.4, 20}, 0.2, {.friction = 0})}}};
    paddle.def.canSleep = false;
    scene.bodies.push_back(paddle);
    scene.joints.push_back(
        {"motor", "ground", "paddle",
         RevoluteJointDef{.anchor = axis, .motorSpeed = 5, .maxMotorTorque = std::numeric_limits<double>::infinity()}});
    const Material material{.density = 0.25, .friction = 0.1, .restitution = 0.1};
    const ShapeDef kinds[] = {capsule({-0.25, 0}, {0.25, 0}, 0.25, material), circle(0.35, material),
                              box({0.35, 0.35}, material)};
    for (int i = 0; i < count; ++i)
        addBody(scene, kinds[i % 3], {-23 + (i % columns) * spacing, 2 + (i / columns) * spacing});
    return scene;
}

}  // namespace plumb::compare
