// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

const Vec2 pivot(0, 2);

const std::string verlet = "second order: velocity Verlet with the same sub-steps, of 1/240 s, is off by ";

/// The point at the distance l from the pivot, at an angle from straight down.
Vec2 hangingAt(double angle, double length) {
    return pivot - length * perp(direction(angle));
}

/// A body on a hinge at the pivot, released at rest.
Scene onHinge(const SceneBody& body) {
    return {
        .duration = 5,
        .bodies = {pivotBody(pivot), body},
        .joints = {{"hinge", "pivot", body.name, RevoluteJointDef{.anchor = pivot}}},
        .closedForm = ClosedForm{.formula = "sin(t/2) = k sn(w t + K, k), k = sin(t0/2), w^2 = m g l / I_pivot",
                                 .source = "Landau, Lifshitz, Mechanics, section 11; period T0 / AGM(1, cos(t0/2))",
                                 .bodies = {SwingsMotion{body.name, "hinge"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{body.name}, .unit = "rad"}},
        .checks = {invariant("joint_error_max", 1e-3, "the limit of the positions"),
                   invariant("energy_drift", 1e-3, "the limit of the positions, over metres of fall")},
    };
}

/// A disc of 1 kg whose centre is 1 m below the hinge: I_pivot = m (l^2 + r^2 / 2).
Scene discOnHinge(double amplitude) {
    const double length = 1;
    const double radius = 0.1;
    const SceneBody bob{
        "bob",
        {.position = hangingAt(amplitude, length), .shapes = {circle(radius, {.density = discDensity(1, radius)})}}};
    return onHinge(bob);
}

SceneBody weight(const std::string& name, const Vec2& position) {
    const double radius = 0.15;
    return {name,
            {.position = position, .canSleep = false, .shapes = {circle(radius, {.density = discDensity(1, radius)})}}};
}

SceneJoint rod(const std::string& name, const SceneBody& a, const SceneBody& b) {
    return {name, a.name, b.name, DistanceJointDef{.anchorA = a.def.position, .anchorB = b.def.position}};
}

}  // namespace

Scene pendulum45() {
    Scene scene = discOnHinge(degrees(45));
    scene.name = "pendulum_45";
    scene.question = "How much longer than a small swing does a swing of 45 degrees take?";
    scene.checks.push_back(ExactCheck{1e-3, verlet + "0.07 mm; the hinge gives way by as much"});
    return scene;
}

Scene pendulum150() {
    Scene scene = discOnHinge(degrees(150));
    scene.name = "pendulum_150";
    scene.question = "How long does a swing of 150 degrees take, almost over the top?";
    scene.checks.push_back(ExactCheck{1e-3, verlet + "0.03 mm; the hinge gives way by 0.2 mm under 4.7 weights"});
    return scene;
}

Scene pendulumStep() {
    // With longer steps it moves in pieces of them, whose number changes from step to step, so no order can be seen.
    Scene scene = discOnHinge(degrees(45));
    scene.name = "pendulum_step";
    scene.question = "By how much does the error of a swing fall when the step is halved?";
    scene.dt = 1.0 / 30;
    scene.checks = {
        ExactCheck{
            7e-4,
            "second order: velocity Verlet with the same sub-steps, h = 1/120 s, is off by 0.3 mm, and chords that "
            "are (h w)^2 / 6 short of their arcs, at up to w = 2.4 rad/s, by at most 0.4 mm more"},
        OrderCheck{.order = 1.8,
                   .reason = "what hangs moves to second order; 0.2 for the terms beyond the leading one"},
    };
    return scene;
}

Scene rodPendulum90() {
    // A slender box that hangs by its end: I_pivot = m (L^2 + w^2) / 12 + m l^2, l = L / 2.
    const double amplitude = degrees(90);
    const Vec2 halfSize(0.02, 0.5);
    const double length = halfSize.y();
    const SceneBody body{"rod",
                         {.position = hangingAt(amplitude, length), .angle = amplitude, .shapes = {box(halfSize)}}};
    Scene scene = onHinge(body);
    scene.name = "rod_pendulum_90";
    scene.question = "How long does a rod of 1 m that hangs by its end take to swing from level to level and back?";
    scene.checks.push_back(ExactCheck{1e-3, verlet + "0.09 mm; the hinge gives way by as much"});
    scene.checks.push_back(invariant("probe.angle", 2e-3, "the limit of the positions, over half a metre"));
    return scene;
}

Scene doublePendulum() {
    const SceneBody anchor = pivotBody(pivot);
    const SceneBody upper = weight("upper", hangingAt(degrees(60), 1));
    const SceneBody lower = weight("lower", upper.def.position + Vec2(0, -1));
    return {
        .name = "double_pendulum",
        .question = "Two weights swing on two rods: how long do the engines tell the same story?",
        .duration = 10,
        .bodies = {anchor, upper, lower},
        .joints = {rod("upper_rod", anchor, upper), rod("lower_rod", upper, lower)},
        .checks =
            {AgreeCheck{0.1, 1,
                        "semi-implicit Euler is half a step ahead: v dt / 2 with v up to 6 m/s is 5 cm, "
                        "and the lower weight adds the upper one's"},
             invariant("energy_drift", 1e-2, "second order at 240 sub-steps a second, over ten wild seconds"),
             invariant(
                 "joint_error_max", 1e-3,
                 "a rod gives way as a spring of 60 Hz, g / (2 pi 60)^2 = 0.07 mm a weight, and carries ten at most")},
    };
}

Scene doublePendulumMinute() {
    Scene scene = doublePendulum();
    scene.name = "double_pendulum_minute";
    scene.question = "Two weights swing on two rods: is their energy still there after a minute?";
    scene.duration = 60;
    scene.checks = {invariant("energy_drift", 1e-2, "nothing takes energy: second order at 240 sub-steps a second"),
                    invariant("joint_error_max", 1e-3, "nobody sees an error of 1 mm in 1 m")};
    return scene;
}

Scene hangingChain() {
    const SceneBody anchor = pivotBody(pivot);
    const SceneBody weights[] = {weight("weight_1", pivot + Vec2(0, -1)), weight("weight_2", pivot + Vec2(0, -2)),
                                 weight("weight_3", pivot + Vec2(0, -3))};
    Scene scene{
        .name = "hanging_chain",
        .question = "Three weights of 1 kg hang below each other: how hard does each rod pull?",
        .duration = 3,
        .bodies = {anchor, weights[0], weights[1], weights[2]},
        .joints = {rod("rod_1", anchor, weights[0]), rod("rod_2", weights[0], weights[1]),
                   rod("rod_3", weights[1], weights[2])},
        .closedForm = ClosedForm{.formula = "x = x0, F = m g for each weight below", .source = "textbook: statics"},
        .checks = {ExactCheck{1e-3,
                              "a rod gives way as a spring of 60 Hz, g / (2 pi 60)^2 = 0.07 mm a weight: half of "
                              "three, two and one times that "
                              "make 0.31 mm at the lowest weight"}},
    };
    for (int i = 0; i < 3; ++i) {
        const std::string number = std::to_string(i + 1);
        scene.closedForm->bodies.push_back(RestsMotion{weights[i].name});
        scene.probes.push_back({.name = "pull_" + number,
                                .quantity = JointForceProbe{"rod_" + number},
                                .expected = (3 - i) * gravity,
                                .from = 1,
                                .unit = "N"});
        scene.checks.push_back(
            invariant("probe.pull_" + number, 0.01 * gravity, "1 % of a weight, a second after the start"));
    }
    return scene;
}

}  // namespace plumb::compare
