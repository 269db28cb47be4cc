// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene dominoes() {
    const Vec2 halfSize(0.05, 0.5);  // [m]
    const double spacing = 0.4;      // [m]
    const int count = 15;
    Scene scene{
        .name = "dominoes",
        .question = "Does a push run through a row of fifteen dominoes?",
        .duration = 8,
        .bodies = {floorBody()},
        .probes =
            {{.name = "last", .quantity = AngleProbe{"domino_15"}, .expected = -degrees(90), .from = 7, .unit = "rad"}},
        .checks = {invariant("probe.last", 2e-3, "the last lies flat: two ends 1 m apart, sunk below 1 mm each"),
                   invariant(
                       "penetration_max", 0.0125,
                       "a domino's top meets the next one at up to 3 m/s: what it moves in a sub-step of 1/240 s"),
                   invariant("settle_time", 5, "the push passes some six dominoes a second, then all lies"),
                   AgreeCheck{0.05, 1,
                              "Box2D 2.4 keeps polygons 2 cm apart: its hits come earlier, and the heads stay as far "
                              "behind"}},
    };
    for (int i = 0; i < count; ++i)
        scene.bodies.push_back({"domino_" + std::to_string(i + 1),
                                {.position = {-4 + spacing * i, halfSize.y()}, .shapes = {box(halfSize)}}});
    // The first domino turns about its lower right corner, so the velocity of its centre follows from the turning.
    const double turning = -2;  // [rad/s]
    BodyDef& first = scene.bodies[1].def;
    first.angularVelocity = turning;
    first.velocity = turning * Vec2(-halfSize.y(), -halfSize.x());
    return scene;
}

}  // namespace plumb::compare
