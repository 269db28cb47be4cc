// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double muzzleSpeed = 20;

/// A ball for each of the angles 15, 30, ... 75 degrees, named after its angle. The balls pass through each other.
Scene fan() {
    Scene scene;
    scene.duration = 4;
    scene.closedForm = ClosedForm{};
    for (int angle = 15; angle <= 75; angle += 15) {
        const std::string name = "ball_" + std::to_string(angle);
        const Vec2 velocity = muzzleSpeed * direction(degrees(angle));
        ShapeDef ball = circle(0.1, {.density = discDensity(1, 0.1)});
        ball.filter.group = -1;
        scene.bodies.push_back({name, {.velocity = velocity, .shapes = {ball}}});
        scene.closedForm->bodies.push_back(FreeMotion{name});
    }
    return scene;
}

}  // namespace

Scene projectileFan() {
    Scene scene = fan();
    scene.name = "projectile_fan";
    scene.question = "Of five shots at 20 m/s, 15 degrees apart, which comes farthest, and which two come as far?";
    scene.closedForm->formula = "x = v t cos a, y = v t sin a - g t^2 / 2";
    scene.closedForm->source = "textbook: constant acceleration; the lecture's slides 12 to 16";
    scene.checks = {ExactCheck{1e-9, "nothing touches the bodies: each step is the formula itself"}};
    return scene;
}

Scene projectileFanDrag() {
    const double drag = 0.2;  // k / m, with 1 kg
    const Vec2 wind(-5, 0);
    Scene scene = fan();
    scene.name = "projectile_fan_drag";
    scene.question = "The same five shots against a wind of 5 m/s, in air that takes a fifth of their speed a second?";
    scene.fields = {{.name = "air", .def = {.law = Drag{.linear = drag, .wind = wind}}}};
    scene.closedForm->formula = "x = (u - c) (1 - e^(-k t)) / k + c t, c = wind + g / k";
    scene.closedForm->source = "textbook: linear drag, dv/dt = g - k (v - wind)";
    scene.checks = {ExactCheck{1e-9, "gravity, linear drag and wind are steady: each step is the formula itself"}};
    return scene;
}

}  // namespace plumb::compare
