// SPDX-License-Identifier: MIT
#include <compare/formula/flights.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double ballRadius = 0.5;  // [m]
constexpr double dt = 1.0 / 60;     // [s]

Scene droppedBall(const DroppedBall& ball) {
    const Vec2 start = ball.rest + Vec2(0, ball.height);
    return {
        .duration = ball.until,
        .dt = dt,
        .bodies = {floorBody(),
                   {"ball", {.position = start, .shapes = {circle(ballRadius, {.restitution = ball.restitution})}}}},
        .closedForm = ClosedForm{.formula = "flight n leaves at e^n sqrt(2 g h) and lasts 2 e^n sqrt(2 h / g)",
                                 .source = "textbook: Newton's law of impact",
                                 .bodies = {FreeMotion{"ball", 2 * dt}}},
    };
}

}  // namespace

Scene bounce08() {
    Scene scene = droppedBall({.rest = {0, ballRadius}, .height = 2.7, .restitution = 0.8, .until = 8});
    scene.name = "bounce_08";
    scene.question = "How high does a ball with e = 0.8 bounce each time, and when does it lie still?";
    scene.checks = {
        ExactCheck{1e-3,
                   "each impact is solved at its own time; flights shorter than two steps count as rest, and the "
                   "first of them still rises 0.8^36 * 2.7 m = 0.88 mm"},
        invariant("penetration_max", 1e-3, sinksOnGround + "half of it under a disc"),
    };
    return scene;
}

Scene bounce1() {
    // Twenty bounces: the last apex is at 40 sqrt(2 * 5 / g) = 40.386 s.
    Scene scene = droppedBall({.rest = {0, ballRadius}, .height = 5, .restitution = 1, .until = 40.5});
    scene.name = "bounce_1";
    scene.question = "Does a ball with e = 1 come back to 5 m twenty times?";
    scene.checks = {
        ExactCheck{1e-6,
                   "each impact is solved at its own time in double: what is left is rounding and the accuracy "
                   "of that time, 1e-9 s at 10 m/s, over twenty impacts and their echo"},
        invariant("energy_drift", 2e-7, "1e-6 m of height is 1e-6 / 5.5 of the energy"),
    };
    return scene;
}

Scene wallTouch() {
    const Vec2 start(-2.1, 0);
    const double speed = 0.9;
    const Material elastic{.friction = 0, .restitution = 1};
    return {
        .name = "wall_touch",
        .question = "Does a ball that touches a wall at 0.9 m/s with e = 1 leave it at 0.9 m/s?",
        .gravity = {0, 0},
        .duration = 4,
        .bodies = {{"wall", {.type = BodyType::Static, .position = {0.25, 0}, .shapes = {box({0.25, 2})}}},
                   {"ball", {.position = start, .velocity = {speed, 0}, .shapes = {circle(ballRadius, elastic)}}}},
        .closedForm = ClosedForm{.formula = "v' = -e v at the wall",
                                 .source = "textbook: Newton's law of impact",
                                 .bodies = {FreeMotion{"ball"}}},
        .checks = {ExactCheck{1e-6, "one impact, solved at its own time in double"},
                   invariant("energy_drift", 1e-9, "an elastic impact with a wall only turns the velocity round")},
    };
}

}  // namespace plumb::compare
