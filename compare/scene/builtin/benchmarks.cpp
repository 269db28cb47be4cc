// SPDX-License-Identifier: MIT
// Mechanisms from the library of computational benchmark problems of the IFToMM's committee for multibody dynamics. The
// results of other programs for them are published.
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A thin bar of 1 m and 1 kg that touches nothing.
SceneBody bar(const std::string& name, const Vec2& middle, double angle, const Vec2& velocity, double turning) {
    ShapeDef shape = box({0.5, 0.02});
    shape.filter.mask = 0;
    return {name,
            {.position = middle,
             .angle = angle,
             .velocity = velocity,
             .angularVelocity = turning,
             .mass = Mass{1, {0, 0}, 1.0 / 12},
             .shapes = {shape}}};
}

}  // namespace

Scene doubleFourBar() {
    Scene scene{
        .name = "double_four_bar",
        .question = "Five bars on seven hinges fall through the places where they lie in line: is their energy kept?",
        .duration = 10,
        .sleeping = false,
        .bodies = {pivotBody({0, 0})},
        .checks =
            {invariant(
                 "energy_drift", 2.8e-4,
                 "0.114 J are published for the generalised-alpha method with steps of 0.01 s; this is 20 mJ with "
                 "sub-steps of 1/240 s, to second order: of 70 J"),
             invariant("joint_error_max", 1e-4, "nobody sees an error of 0.1 mm")},
    };
    const double speed = 1;  // of the top [m/s]
    for (int i = 0; i < 3; ++i) {
        const std::string upright = "upright_" + std::to_string(i + 1);
        scene.bodies.push_back(bar(upright, Vec2(i, 0.5), degrees(90), {speed / 2, 0}, -speed));
        hinge(scene, "foot_" + std::to_string(i + 1), "pivot", upright, Vec2(i, 0));
    }
    for (int i = 0; i < 2; ++i) {
        const std::string number = std::to_string(i + 1), top = "top_" + number;
        scene.bodies.push_back(bar(top, Vec2(i + 0.5, 1), 0, {speed, 0}, 0));
        hinge(scene, "left_" + number, "upright_" + number, top, Vec2(i, 1));
        hinge(scene, "right_" + number, top, "upright_" + std::to_string(i + 2), Vec2(i + 1, 1));
    }
    return scene;
}

Scene pendulumHorizontal() {
    // Its rod pulls at the middle of the disc. So the disc never turns, and moves as a point does.
    const double radius = 0.05;
    ShapeDef disc = circle(radius, {.density = discDensity(1, radius)});
    disc.filter.mask = 0;
    const SceneBody bob{"bob", {.position = {-1, 0}, .shapes = {disc}}};
    return {
        .name = "pendulum_horizontal",
        .question = "How long does a weight on a rod of 1 m that is let go level take to swing across and back?",
        .duration = 10,
        .sleeping = false,
        .bodies = {pivotBody({0, 0}), bob},
        .joints = {{"rod", "pivot", "bob", DistanceJointDef{.anchorA = {0, 0}, .anchorB = bob.def.position}}},
        .closedForm = ClosedForm{.formula = "sin(t/2) = k sn(w t + K, k), k = sin(t0/2), w^2 = g / L",
                                 .source = "Landau, Lifshitz, Mechanics, section 11; period T0 / AGM(1, cos(t0/2))",
                                 .bodies = {SwingsMotion{"bob", "rod"}}},
        .checks = {ExactCheck{2e-3,
                              "second order: 60 h^2 were measured with ever finer steps, 1.05 mm with sub-steps of "
                              "1/240 s; twice that"},
                   invariant("energy_drift", 1.4e-4,
                             "5e-5 J are published for steps of 0.8 ms; this is 1.36 mJ with sub-steps of 1/240 s, "
                             "to second order: of 9.81 J"),
                   invariant("joint_error_max", 1e-4, "nobody sees an error of 0.1 mm")},
    };
}

}  // namespace plumb::compare
