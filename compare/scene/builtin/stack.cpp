// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A box of 1 m and 1 kg.
SceneBody boxBody(const std::string& name, const Vec2& position) {
    return {name, {.position = position, .shapes = {box({0.5, 0.5})}}};
}

constexpr const char* settledReason = "all start where they rest";

}  // namespace

Scene boxAtRest() {
    const Vec2 start(0, 0.5);
    return {
        .name = "box_at_rest",
        .question = "Does a box that stands on the floor stay where it is?",
        .duration = 5,
        .bodies = {floorBody(), boxBody("box", start)},
        .closedForm =
            ClosedForm{.formula = "x = x0, N = m g", .source = "textbook: statics", .bodies = {FreeMotion{"box"}}},
        .probes = {{.name = "normal",
                    .quantity = NormalForceProbe{"floor", "box"},
                    .expected = gravity,
                    .from = 0.5,
                    .unit = "N"}},
        .checks = {ExactCheck{1e-3, sinksOnGround + "5/8 of it under a box"},
                   invariant("penetration_max", 1e-3, sinksOnGround + "5/8 of it under a box"),
                   invariant("probe.normal", 0.01 * gravity, "1 %: the floor carries the weight"),
                   invariant("settle_time", 0.5, settledReason)},
    };
}

Scene stackOfTen() {
    Scene scene{
        .name = "stack_of_ten",
        .question = "Ten boxes of 1 kg stand on each other: does the i-th contact from the top carry i weights?",
        .duration = 10,
        .bodies = {floorBody()},
        .checks = {AgreeCheck{0.16, 10,
                              "Box2D 2.4 keeps polygons 2 cm apart, less 5 mm: 15 mm at each of ten contacts"},
                   invariant("penetration_max", 4e-3,
                             sinks + "9 * 5/4 of it, 3.1 mm, between the lowest boxes under nine weights"),
                   invariant("settle_time", 2, settledReason)},
    };
    for (int i = 0; i < 10; ++i) {
        SceneBody body = boxBody("box_" + std::to_string(i + 1), {0, 0.5 + i});
        body.def.canSleep = false;  // its forces are watched to the end
        scene.bodies.push_back(body);
        const int carried = 10 - i;
        const std::string name = "normal_" + std::to_string(carried);
        const std::string below = scene.bodies[static_cast<std::size_t>(i)].name;
        scene.probes.push_back({.name = name,
                                .quantity = NormalForceProbe{below, body.name},
                                .expected = carried * gravity,
                                .from = 5,
                                .unit = "N"});
        scene.checks.push_back(invariant("probe." + name, 0.01 * carried * gravity, "1 % of what it carries"));
    }
    return scene;
}

Scene smallPyramid() {
    Scene scene{
        .name = "small_pyramid",
        .question = "Does a pyramid of ten boxes keep standing?",
        .duration = 5,
        .bodies = {floorBody()},
        .checks = {AgreeCheck{0.07, 5,
                              "Box2D 2.4 keeps polygons 2 cm apart, less 5 mm: 15 mm at each of four contacts"},
                   invariant("penetration_max", 2e-3,
                             sinks + "no box carries more than three weights, 3 * 5/4 of it, 1 mm"),
                   invariant("settle_time", 2, settledReason)},
    };
    const double spacing = 1.1;  // a gap of 10 cm between neighbours
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4 - row; ++column) {
            const std::string name = "box_" + std::to_string(row + 1) + "_" + std::to_string(column + 1);
            scene.bodies.push_back(boxBody(name, {spacing * (column - (3 - row) / 2.0), 0.5 + row}));
        }
    }
    return scene;
}

}  // namespace plumb::compare
