// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene terminalSpeed() {
    const double drag = 0.005;  // [kg/m], with 1 kg
    const double fastest = std::sqrt(gravity / drag);
    return {
        .name = "terminal_speed",
        .question = "How fast does a ball come to fall in air that holds it back by the square of its speed?",
        .duration = 20,
        .bodies = {{"ball", {.shapes = {circle(0.1, {.density = discDensity(1, 0.1)})}}}},
        .fields = {{.name = "air", .def = {.law = Drag{.quadratic = drag}}}},
        .closedForm = ClosedForm{.formula = "v = v_t tanh(g t / v_t), x = -(v_t^2 / g) ln cosh(g t / v_t)",
                                 .source = "textbook: m v' = m g - c v^2, v_t = sqrt(m g / c) = 44.3 m/s",
                                 .bodies = {FreeMotion{"ball"}}},
        .probes = {{.name = "terminal_speed",
                    .quantity = VelocityProbe{"ball", {0, -1}},
                    .expected = fastest * std::tanh(gravity * 20 / fastest),
                    .unit = "m/s",
                    .watch = Watch::Last}},
        .checks = {ExactCheck{1e-3, "second order in the sub-step of 4 ms"},
                   OrderCheck{1.9, {}, "second order: each half of a step takes the drag of its middle"},
                   invariant("probe.terminal_speed", 1e-5, "drag is steady at the terminal speed, whatever the step")},
    };
}

Scene twoBodyOrbit() {
    // e = 0.5, a = 10 m, G M = 1000 m^3/s^2. They start at the far end, and move about their common centre, which
    // drifts.
    const double a = 10, e = 0.5, total = 1000, period = 2 * std::numbers::pi * std::sqrt(a * a * a / total);
    const double speed = std::sqrt(total / a * (1 - e) / (1 + e));
    const Vec2 drift(0.5, 0.25);
    const auto body = [&](const char* name, double mass, double share) -> SceneBody {
        return {name,
                {.position = {share * a * (1 + e), 0},
                 .velocity = drift + Vec2(0, share * speed),
                 .shapes = {circle(0.5, {.density = discDensity(mass, 0.5)})}}};
    };
    return {
        .name = "two_body_orbit",
        .question = "Two stars go round each other three times: do they come back to where Kepler has them?",
        .gravity = {0, 0},
        .duration = 3 * period,
        .dt = period / 360,
        .bodies = {body("sun", 750, -0.25), body("star", 250, 0.75)},
        .fields = {{.name = "gravitation", .def = {.law = MutualGravity{.constant = 1}}}},
        .closedForm = ClosedForm{.formula = "x = a (cos E - e), y = a sqrt(1 - e^2) sin E, E - e sin E = 2 pi t / T",
                                 .source = "Kepler; two bodies go about their common centre, T^2 = 4 pi^2 a^3 / (G M)",
                                 .bodies = {OrbitsMotion{"sun", "gravitation"}, OrbitsMotion{"star", "gravitation"}}},
        // Velocity Verlet keeps H + h^2 P / 24, P = 2 v.V''v - |V'|^2 with V = -G M / r, h = T / 1440. Over one period
        // the mean of P is (G M)^2 (1 + e^2 / 2) / (a^4 (1 - e^2)^(5/2)); the slope of this mean over the angular
        // momentum turns the ellipse. P itself is 0 at the far end, where the two start. It is largest at the near end:
        // 2 (G M)^2 / r^4.
        .checks = {ExactCheck{4e-3,
                              "second order: velocity Verlet turns the ellipse back by (n h)^2 (15 / (1 - e^2)^3 - 3 / "
                              "(1 - e^2)^2) / 48 rad by n t = 1: 0.23 mrad in three rounds, 2.5 mm of 11.25 m"},
                   OrderCheck{1.9, {}, "velocity Verlet"},
                   invariant("energy_drift", 2.5e-5,
                             "velocity Verlet's energy is off by h^2 P / 24 at the near end: 0.48 J of 28 kJ"),
                   invariant("momentum_drift", 1e-12, "each pulls as hard as it is pulled"),
                   invariant("angular_momentum_drift", 1e-12, "each pulls along the line between them")},
    };
}

Scene buoyantBox() {
    // Half as dense as water, 1 m wide and 0.5 m high: at rest its middle is at the water's surface. Released 0.1 m
    // above that, it bobs: m x'' = -rho g w x.
    const double width = 1, height = 0.5, water = 1000, wood = 500;
    return {
        .name = "buoyant_box",
        .question = "A wooden box is let go a hand's breadth above where it floats: how does it bob?",
        .duration = 5,
        .sleeping = false,
        .bodies = {{"box",
                    {.position = {0, 0.1},
                     .fixedRotation = true,
                     .shapes = {box({width / 2, height / 2}, {.density = wood})}}}},
        .fields = {{.name = "water", .def = {.law = Pool{.fluid = {.density = water}}}}},
        .closedForm = ClosedForm{.formula = "x = x0 cos(w t), w^2 = rho g b / m",
                                 .source = "Archimedes: each metre deeper displaces rho b more of water",
                                 .bodies = {FloatsMotion{"box", "water"}}},
        .checks = {ExactCheck{1.7e-4,
                              "second order: the phase is off by (w h)^2 / 24 = 2.8e-5 of 31 rad, times 0.1 m: 9e-5 m"},
                   OrderCheck{1.9, {}, "velocity Verlet"},
                   invariant("energy_drift", 3.4e-4,
                             "velocity Verlet's energy is off by (w h)^2 / 4 = 1.7e-4 of the swing's, or less")},
    };
}

Scene magnetCatch() {
    // The two fall towards each other: d'' = -S (1/m1 + 1/m2) / d^2, which is half an ellipse of width 0.
    const double strength = 4, apart = 2, m1 = 1, m2 = 3, a = apart / 2;
    const double pull = strength * (1 / m1 + 1 / m2), period = 2 * std::numbers::pi * std::sqrt(a * a * a / pull);
    const double radius = 0.1;
    const auto cart = [&](const char* name, double x, double mass) -> SceneBody {
        return {name, {.position = {x, 0}, .shapes = {circle(radius, {.density = discDensity(mass, radius)})}}};
    };
    return {
        .name = "magnet",
        .question = "A magnet and a piece of iron draw each other on ice: when and where do they meet, and stay?",
        .gravity = {0, 0},
        .duration = 2,
        .bodies = {cart("magnet", 0, m2), cart("iron", apart, m1)},
        .fields = {{.name = "pull",
                    .def = {.law = Magnet{.pull = {.strength = strength, .power = 2}}},
                    .body = "magnet"}},
        .closedForm = ClosedForm{.formula = "d = a (1 + cos E), E + sin E = 2 pi t / T, until they touch",
                                 .source = "the inverse square law with no sideways motion: an ellipse of e = 1",
                                 .until = 0.42 * period,
                                 .bodies = {OrbitsMotion{"magnet", "pull"}, OrbitsMotion{"iron", "pull"}}},
        .probes = {{.name = "meets_at",
                    .quantity = PositionProbe{"magnet", {1, 0}},
                    .expected = apart * m1 / (m1 + m2) - 2 * radius * m1 / (m1 + m2),
                    .unit = "m",
                    .watch = Watch::Last}},
        .checks = {ExactCheck{1e-3, "second order in the sub-step"},
                   invariant("momentum_drift", 1e-6,
                             "each pulls as hard as it is pulled; the contact solver uses floats"),
                   invariant("probe.meets_at", 1e-3, "they meet where their common centre is, and nothing moves that")},
    };
}

}  // namespace plumb::compare
