// SPDX-License-Identifier: MIT
#include <plumb/ballistics/moving_target.h>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene movingTarget() {
    // The muzzle is at the origin; the duck flies past, 6 m up. Each way to hit it is a separate shot.
    const Vec2 duck(25, 6), velocity(-6, 1);
    const double speed = 22, duckRadius = 0.3, shotRadius = 0.05;
    const std::vector<Shot> shots = aimAtMoving({.target = duck, .targetVelocity = velocity, .speed = speed});
    ShapeDef gate = circle(duckRadius);
    gate.sensor = true;
    Scene scene{
        .name = "moving_target",
        .question = "Shots are aimed at a duck that flies by: do they meet it, and when?",
        .duration = shots.back().time + 0.5,
        .bodies = {{"duck", {.type = BodyType::Kinematic, .position = duck, .velocity = velocity, .shapes = {gate}}}},
        .closedForm = ClosedForm{.formula = "d + w t = u t + g t^2 / 2",
                                 .source = "the quartic |d + w t - g t^2 / 2| = v t; replayed as constant acceleration",
                                 .bodies = {FreeMotion{"duck"}}},
    };
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const std::string name = "shot_" + std::to_string(i + 1);
        ShapeDef ball = circle(shotRadius);
        ball.filter.group = -1;
        scene.bodies.push_back({name, {.velocity = shots[i].velocity, .shapes = {ball}}});
        scene.closedForm->bodies.push_back(FreeMotion{name});
    }
    scene.probes = {{.name = "hits",
                     .quantity = SensorCountProbe{"duck"},
                     .expected = static_cast<double>(shots.size()),
                     .unit = "hits",
                     .watch = Watch::Last}};
    scene.checks = {ExactCheck{1e-9, "nothing touches the bodies: each step is the formula itself"},
                    invariant("probe.hits", 0, "every shot is aimed at the duck's middle")};
    return scene;
}

}  // namespace plumb::compare
