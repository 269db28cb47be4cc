// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// Boxes of 1 m stand on each other on the floor, each with its own mass, the lowest first.
Scene tower(const std::vector<double>& masses) {
    Scene scene{.bodies = {floorBody()}};
    ClosedForm still{.formula = "x = x0", .source = "textbook: statics"};
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const std::string name = "box_" + std::to_string(i + 1);
        const Vec2 position(0, 0.5 + static_cast<double>(i));
        scene.bodies.push_back({name, {.position = position, .shapes = {box({0.5, 0.5}, {.density = masses[i]})}}});
        still.bodies.push_back(PiecewiseMotion{name, {{.position = position}}});
    }
    scene.closedForm = still;
    return scene;
}

}  // namespace

Scene tallStack() {
    Scene scene = tower(std::vector<double>(30, 1));
    scene.name = "tall_stack";
    scene.question = "Do thirty boxes stand on each other for a minute, and how far does the top sink?";
    scene.duration = 60;
    scene.checks = {
        ExactCheck{0.16, sinks + "5/4 of it for each weight a contact carries, 435 in all, and 30 * 5/8 of 0.07 mm on "
                                 "the floor: 151 mm at the top"},
        invariant("penetration_max", 0.0105, sinks + "29 * 5/4 of it, 10.1 mm, between the lowest boxes"),
        invariant("settle_time", 2, "all start where they rest")};
    return scene;
}

Scene stackAwake() {
    Scene scene = tower(std::vector<double>(15, 1));
    scene.name = "stack_awake";
    scene.question = "Do fifteen boxes that may not sleep stand on each other for a minute?";
    scene.duration = 60;
    scene.sleeping = false;
    scene.checks = {
        ExactCheck{0.04, sinks +
                             "5/4 of it for each weight a contact carries, 105 in all, and 15 * 5/8 of 0.07 mm on "
                             "the floor: 37 mm at the top; contacts that rest keep their arms, so it does not lean"},
        invariant("penetration_max", 0.0055, sinks + "14 * 5/4 of it, 4.9 mm, between the lowest boxes"),
        invariant("settle_time", 2, "all start where they rest")};
    return scene;
}

Scene heavyOnLight() {
    Scene scene = tower({1, 1, 100});
    scene.name = "heavy_on_light";
    scene.question = "Does a box of 100 kg stand on two of 1 kg?";
    scene.duration = 20;
    scene.sleeping = false;  // its forces are watched to the end
    const std::string names[] = {"floor", "box_1", "box_2", "box_3"};
    for (std::size_t i = 0; i < 3; ++i) {
        const double load = (102 - static_cast<double>(i)) * gravity;
        const std::string name = "normal_" + std::to_string(i + 1);
        scene.probes.push_back({.name = name,
                                .quantity = NormalForceProbe{names[i], names[i + 1]},
                                .expected = load,
                                .from = 5,
                                .unit = "N"});
        scene.checks.push_back(invariant("probe." + name, 0.01 * load, "1 % of what it carries"));
    }
    scene.checks.push_back(
        ExactCheck{0.001,
                   "the springs on the way of the load are as firm as the heavy box needs: under 100 weights "
                   "each gives way by no more than under one, 0.34 mm and, on the floor, 0.07 mm"});
    scene.checks.push_back(invariant("penetration_max", 0.0005, "each contact gives way as under one weight, 0.34 mm"));
    scene.checks.push_back(invariant("settle_time", 2, "all start where they rest"));
    return scene;
}

}  // namespace plumb::compare
