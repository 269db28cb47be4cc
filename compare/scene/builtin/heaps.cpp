// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/doll.h>
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A stone with eight sides that lies on one of them. radius is the distance of its sides from its middle.
ShapeDef boulder(double radius) {
    const double side = degrees(45), out = radius / sinCos(side / 2).cos;
    std::vector<Vec2> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(out * direction((i + 0.5) * side));
    return polygon(corners, {.density = 2000});
}

}  // namespace

Scene ropeHeapsUp() {
    constexpr int links = 60;
    const Vec2 half(0.04, 0.1), lean(0.01, 2 * half.y());  // [m]
    Scene scene{.name = "rope_heaps_up",
                .question = "Does a rope of 60 links hold together while it falls in a heap, and lie still there?",
                .duration = 20,
                .bodies = {{"ground", {.type = BodyType::Static, .position = {0, -1}, .shapes = {box({20, 1})}}}}};
    for (int i = 0; i < links; ++i) {
        const std::string name = "link_" + std::to_string(i + 1);
        const Vec2 place = Vec2(0, 1 + half.y()) + i * lean;
        scene.bodies.push_back({name, {.position = place, .shapes = {box(half)}}});
        if (i > 0) hinge(scene, "hinge_" + std::to_string(i), "link_" + std::to_string(i), name, place - lean / 2);
    }
    scene.checks = {
        invariant("joint_error_max", 5e-3, "a fortieth of a link, while links fall on links from 13 m"),
        // By chance: under 60 gravities near this one it is 54 mm in the middle, and 109 mm at the most.
        invariant("penetration_max", 8e-2, "the 8 cm by which a link at 16 m/s would pass another"),
        invariant("settle_time", 15, "the last link falls for 1.6 s; then friction stops the heap"),
    };
    return scene;
}

Scene dollOnBoulders() {
    constexpr int boulders = 20;
    constexpr double fall = 3;  // [m]
    Scene scene{.name = "doll_on_boulders",
                .question = "Does a doll that falls 3 m onto loose boulders hold together, and lie still?",
                .duration = 10,
                .bodies = {{"ground", {.type = BodyType::Static, .position = {0, -1}, .shapes = {box({20, 1})}}}}};
    for (int i = 0; i < boulders; ++i) {
        const double radius = 0.15 + 0.05 * (i % 3), x = 0.55 * (i - (boulders - 1) / 2.0);
        scene.bodies.push_back(
            {"boulder_" + std::to_string(i + 1), {.position = {x, radius}, .shapes = {boulder(radius)}}});
    }
    addDoll(scene, {.neck = {0, fall + 1.4}, .angle = 0.6});
    scene.checks = {
        invariant("joint_error_max", 1.5e-2, "less than the 3.2 cm that a limb at 7.7 m/s moves in a sub-step"),
        invariant("penetration_max", 3e-2,
                  "limbs of 1 to 8 kg that boulders of 150 kg and more roll onto: Box2D 2.4 lets them in by 10 cm"),
        invariant("settle_time", 8, "it falls for 0.8 s; then friction stops it"),
    };
    return scene;
}

}  // namespace plumb::compare
