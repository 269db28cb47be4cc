// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double springStiffness = 40;  // of 1 kg: w = 6.32 rad/s, a period of 0.99 s [N/m]
constexpr double springLength = 1;      // of the spring without load [m]
constexpr double pull = 0.5;            // how far below the place of rest it starts [m]
constexpr double top = 2;               // height at which the springs are fixed [m]

/// Hangs 1 kg on a spring below (x, top). It is pulled down and released; dampingRatio 1 is critical.
void hang(Scene& scene, const std::string& name, double x, double dampingRatio) {
    const double radius = 0.15;
    const double damping = 2 * dampingRatio * std::sqrt(springStiffness);
    const Vec2 rest(x, top - springLength - gravity / springStiffness);
    const Vec2 start = rest - Vec2(0, pull);
    scene.bodies.push_back(
        {name,
         {.position = start, .canSleep = false, .shapes = {circle(radius, {.density = discDensity(1, radius)})}}});
    scene.joints.push_back({"spring_of_" + name, "pivot", name,
                            DistanceJointDef{.anchorA = {x, top},
                                             .anchorB = start,
                                             .length = springLength,
                                             .spring = Spring{springStiffness, damping}}});
    scene.closedForm->bodies.push_back(SpringsMotion{name, "spring_of_" + name});
}

Scene springScene(const std::string& formula) {
    return {.bodies = {pivotBody({0, top})},
            .closedForm = ClosedForm{.formula = formula, .source = "textbook: harmonic oscillator"}};
}

}  // namespace

Scene springUndamped() {
    Scene scene = springScene("x = x0 cos(w t), w^2 = k / m");
    scene.name = "spring_undamped";
    scene.question = "Does 1 kg on a spring of 40 N/m still swing as far after twenty seconds?";
    scene.duration = 20;
    hang(scene, "weight", 0, 0);
    scene.checks = {
        ExactCheck{
            4e-3,
            "second order: with the same sub-steps, h = 1/240 s, velocity Verlet is ahead by (w h)^2 / 24 of its "
            "angle, 126 rad by the end: 1.8 mm of 0.5 m; twice that"},
        invariant("energy_drift", 1e-2, "nothing takes energy: 1 % over 20 s is 2 mm of its swing"),
    };
    return scene;
}

Scene springsDamped() {
    Scene scene = springScene("m x'' = -k x - c x', c = 2 z sqrt(k m) with z = 0.1, 1 and 2");
    scene.name = "springs_damped";
    scene.question = "How do 1 kg on a spring come to rest that are damped little, just enough and too much?";
    scene.duration = 5;
    hang(scene, "swings", -1, 0.1);
    hang(scene, "critical", 0, 1);
    hang(scene, "creeps", 1, 2);
    scene.checks = {
        ExactCheck{
            1e-3,
            "second order: a damper taken at the step's middle is off by (2 z w h)^2 / 12, with z = 2 and sub-steps "
            "of 1/240 s 0.1 %, of 0.5 m: 0.5 mm, and it dies away"},
    };
    return scene;
}

}  // namespace plumb::compare
