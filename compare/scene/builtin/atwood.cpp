// SPDX-License-Identifier: MIT
#include <compare/formula/atwood.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene atwoodMachine() {
    const AtwoodMachine machine{.massA = 2, .massB = 3, .gravity = gravity};
    const double radius = 0.2;
    const auto weight = [&](const std::string& name, double x, double mass) {
        return SceneBody{name,
                         {.position = {x, 2}, .shapes = {circle(radius, {.density = discDensity(mass, radius)})}}};
    };
    const Vec2 a(-0.5, 2), b(0.5, 2);
    return {
        .name = "atwood_machine",
        .question =
            "Three kilograms and two hang on one rope over a wheel: how do they move, and how hard does it pull?",
        .duration = 1,
        .bodies = {pivotBody({0, 4}), weight("light", a.x(), machine.massA), weight("heavy", b.x(), machine.massB)},
        .joints = {{"rope", "light", "heavy",
                    PulleyJointDef{.groundA = {a.x(), 4}, .groundB = {b.x(), 4}, .anchorA = a, .anchorB = b}}},
        .closedForm = ClosedForm{.formula = "a = g (m1 - m2) / (m1 + m2), T = 2 g m1 m2 / (m1 + m2)",
                                 .source = "Atwood 1784",
                                 .bodies = {HoistedMotion{"light", "rope"}, HoistedMotion{"heavy", "rope"}}},
        .probes = {{.name = "pull",
                    .quantity = JointForceProbe{"rope"},
                    .expected = tensionOf(machine),
                    .from = 0.1,
                    .unit = "N"}},
        .checks = {ExactCheck{1e-4, "constant forces: second order is exact, and the rope gives way by 23.5 N at most"},
                   invariant("probe.pull", 0.01,
                             "0.04 % of 23.5 N: the rounding of a sub-step's impulse in single precision"),
                   invariant("joint_error_max", 1e-4, "the limit of the positions"),
                   invariant("energy_drift", 1e-4, "the limit of the positions over a fall of 1 m")},
    };
}

}  // namespace plumb::compare
