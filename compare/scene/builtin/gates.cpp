// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

Probe countAt(const std::string& name, double expected, double until) {
    return {.name = name,
            .quantity = SensorCountProbe{"gate"},
            .expected = expected,
            .unit = "-",
            .until = until,
            .watch = Watch::Last};
}

}  // namespace

Scene sensorGate() {
    ShapeDef room = box({0.5, 2});
    room.sensor = true;
    Scene scene{.name = "sensor_gate",
                .question = "How many discs does a gate count that fly through it, and does it slow them?",
                .gravity = {0, 0},
                .duration = 3,
                .bodies = {{"gate", {.type = BodyType::Static, .shapes = {room}}}},
                .closedForm = ClosedForm{.formula = "x = x0 + v t", .source = "textbook: nothing touches them"}};
    // The front of disc i reaches the gate's side, at -0.5, after 0.5, 1, 1.5 and 2 s; the last disc does not reach it
    // in time.
    const double radius = 0.2, speeds[] = {3, 4, -2, 6, 1};
    const double arrivals[] = {0.5, 1, 1.5, 2, 3.5};
    for (std::size_t i = 0; i < 5; ++i) {
        const double side = speeds[i] > 0 ? -1 : 1;
        const Vec2 velocity(speeds[i], 0);
        const Vec2 start(side * (0.5 + radius) - arrivals[i] * speeds[i], 1.6 - 0.8 * static_cast<double>(i));
        const std::string name = "disc_" + std::to_string(i + 1);
        scene.bodies.push_back(
            {name, {.position = start, .velocity = velocity, .canSleep = false, .shapes = {circle(radius)}}});
        scene.closedForm->bodies.push_back(FreeMotion{name});
    }
    scene.probes = {countAt("count_0", 0, 0.45), countAt("count_1", 1, 0.95), countAt("count_2", 2, 1.45),
                    countAt("count_3", 3, 1.95), countAt("count_4", 4, 3)};
    scene.checks = {ExactCheck{1e-9, "nothing touches the discs: what is left is rounding"}};
    for (const Probe& probe : scene.probes)
        scene.checks.push_back(invariant("probe." + probe.name, 0, "a visit is counted once, when it begins"));
    return scene;
}

Scene oneWayPlatform() {
    ShapeDef platform = box({2, 0.1}, {.friction = 0});
    platform.oneWay = Vec2(0, 1);
    const double radius = 0.25, top = 2.1, speed = 9;
    const auto ball = [&](const std::string& name, const Vec2& position, const Vec2& velocity) {
        return SceneBody{name, {.position = position, .velocity = velocity, .shapes = {circle(radius)}}};
    };
    const Vec2 up(0, speed), thrown(-1, 0.25), laid(1, top + radius);
    return {
        .name = "one_way_platform",
        .question = "Does a ball pass a platform from below and land on it from above, beside one that lies there?",
        .duration = 3,
        .bodies = {{"platform", {.type = BodyType::Static, .position = {0, top - 0.1}, .shapes = {platform}}},
                   ball("thrown", thrown, up),
                   ball("laid", laid, {0, 0})},
        .closedForm = ClosedForm{.formula = "y = y0 + v t - g t^2 / 2 up through it and down onto it, then at rest",
                                 .source = "textbook: constant acceleration",
                                 .bodies = {FreeMotion{"thrown"}, FreeMotion{"laid"}}},
        .checks = {ExactCheck{1e-3, sinksOnGround + "and nothing holds it back on its way up"}},
    };
}

}  // namespace plumb::compare
