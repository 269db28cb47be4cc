// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr const char* exactReason =
    "nothing touches the body, so each step is the formula itself: what is left is rounding, 1e-15 m a step";
constexpr const char* energyReason = "position and speed are exact, so their energy is";
constexpr const char* kinematics = "x = x0 + v0 t + g t^2 / 2";

}  // namespace

Scene freeFall() {
    const Vec2 start(0, 20);
    return {
        .name = "free_fall",
        .question = "How far does a dropped ball fall in two seconds?",
        .duration = 2,
        .bodies = {{"ball", {.position = start, .shapes = {circle(0.5)}}}},
        .closedForm =
            ClosedForm{
                .formula = kinematics, .source = "textbook: constant acceleration", .bodies = {FreeMotion{"ball"}}},
        .checks = {ExactCheck{1e-9, exactReason}, invariant("energy_drift", 1e-9, energyReason)},
    };
}

Scene projectile() {
    const Vec2 velocity = 20 * direction(degrees(45));
    return {
        .name = "projectile",
        .question = "How high and how far does a shot of 20 m/s at 45 degrees fly?",
        .duration = 3,
        .bodies = {{"ball", {.velocity = velocity, .shapes = {circle(0.1)}}}},
        .closedForm =
            ClosedForm{
                .formula = kinematics, .source = "textbook: constant acceleration", .bodies = {FreeMotion{"ball"}}},
        .checks = {ExactCheck{1e-9, exactReason}, invariant("energy_drift", 1e-9, energyReason)},
    };
}

Scene projectileDamped() {
    const Vec2 velocity = 20 * direction(degrees(45));
    const double damping = 0.2;
    return {
        .name = "projectile_damped",
        .question = "How much of its range does the same shot lose to a drag of 0.2 /s?",
        .duration = 3,
        .bodies = {{"ball", {.velocity = velocity, .linearDamping = damping, .shapes = {circle(0.1)}}}},
        .closedForm = ClosedForm{.formula = "x = x0 + (v0 - g/k) (1 - e^(-k t)) / k + g t / k",
                                 .source = "textbook: linear drag, dv/dt = g - k v",
                                 .bodies = {FreeMotion{"ball"}}},
        .checks = {ExactCheck{1e-9, exactReason}},
    };
}

Scene spinFree() {
    // A heavy head and a long light handle, placed so that they balance at the origin: 0.24 kg at 0.125 m, and 0.08 kg
    // at -0.375 m.
    const ShapeDef head{.shape = boxPolygon({0.1, 0.2}, {0.125, 0}), .material = {.density = 3}};
    const ShapeDef handle{.shape = boxPolygon({0.4, 0.05}, {-0.375, 0}), .material = {.density = 1}};
    const Vec2 velocity(4, 9);
    const double spin = 7;  // a little more than two turns in the two seconds
    return {
        .name = "spin_free",
        .question = "A hammer is thrown spinning: what path does its balance point take, and how far does it turn?",
        .duration = 2,
        .bodies = {{"hammer", {.velocity = velocity, .angularVelocity = spin, .shapes = {head, handle}}}},
        .closedForm = ClosedForm{.formula = "x = x0 + v0 t + g t^2 / 2, angle = w t",
                                 .source = "textbook: gravity pulls at the centre of mass and turns nothing",
                                 .bodies = {FreeMotion{"hammer"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"hammer"}, .unit = "rad"}},
        .checks = {ExactCheck{1e-9, exactReason}, invariant("energy_drift", 1e-9, energyReason),
                   invariant("probe.angle", 1e-9, "no torque: the angle grows by w dt a step, exact to rounding")},
    };
}

}  // namespace plumb::compare
