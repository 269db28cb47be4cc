// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene bulletWall() {
    const double radius = 0.1, halfThickness = 0.005;  // [m]
    const double touching = -halfThickness - radius;   // where a disc's centre is when it touches [m]
    const double way = 4.9;                            // from the start to there [m]
    Scene scene{
        .name = "bullet_wall",
        .question = "Which of six discs at 10 to 1,000 m/s does a wall of 1 cm stop?",
        .gravity = {0, 0},
        .duration = 1,
        // Box2D 3 has no polygon that is so thin, so the wall consists of its two faces.
        .bodies = {{"wall",
                    {.type = BodyType::Static,
                     .shapes = {segment({-halfThickness, -4}, {-halfThickness, 4}),
                                segment({halfThickness, 4}, {halfThickness, -4})}}}},
        .checks = {ExactCheck{1e-3, "a tenth of the wall: a disc stops where it touches, and nothing presses it on"},
                   invariant("penetration_max", 1e-3, "a tenth of the wall")},
    };
    ClosedForm stopped{.formula = "v' = -e v = 0 at the wall", .source = "textbook: Newton's law of impact"};
    double y = -2.5;
    for (const int speed : {10, 30, 100, 200, 400, 1000}) {
        const std::string name = "disc_" + std::to_string(speed);
        const Vec2 start(touching - way, y);
        scene.bodies.push_back(
            {name, {.position = start, .velocity = {speed, 0}, .shapes = {circle(radius, {.friction = 0})}}});
        stopped.bodies.push_back(FreeMotion{name});
        y += 1;
    }
    scene.closedForm = stopped;
    return scene;
}

}  // namespace plumb::compare
