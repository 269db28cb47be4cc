// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double rollerRadius = 0.5;  // [m]
constexpr double rollingSlope = degrees(20);
constexpr double rollingLength = 14;  // [m]

/// A round body of 1 kg rolls down a line for 3 s; k = I / (m r^2).
Scene rollsDown(double k) {
    const Vec2 downhill = direction(-rollingSlope);
    const Vec2 top(0, -rollingLength * downhill.y());
    const Vec2 start = top + downhill + rollerRadius * perp(downhill);
    const Mass mass{.mass = 1, .inertia = k * rollerRadius * rollerRadius};
    return {
        .duration = 3,
        .bodies = {{"incline", {.type = BodyType::Static, .shapes = {segment(top, top + rollingLength * downhill)}}},
                   {"roller", {.position = start, .mass = mass, .shapes = {circle(rollerRadius)}}}},
        .closedForm = ClosedForm{.formula = "a = g sin t / (1 + k), k = I / (m r^2)",
                                 .source = "textbook: rolling without slip; holds for mu >= tan t k / (1 + k)",
                                 .bodies = {FreeMotion{"roller"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"roller"}, .unit = "rad"}},
        .checks = {ExactCheck{1e-3, sinksOnGround +
                                        "half of it under a disc; the roll itself is solved to second order, but for "
                                        "the slip while friction finds its load"},
                   invariant("probe.angle", 1e-3 / rollerRadius, "the limit of the way, over the radius"),
                   invariant("energy_drift", 1e-3, "rolling does no work: the limit of the way, over its metres")},
    };
}

}  // namespace

Scene discRollsDown() {
    Scene scene = rollsDown(0.5);
    scene.name = "disc_rolls_down";
    scene.question = "How fast does a disc roll down 20 degrees?";
    return scene;
}

Scene ringRollsDown() {
    Scene scene = rollsDown(1);
    scene.name = "ring_rolls_down";
    scene.question = "How much slower than a disc does a ring roll down 20 degrees?";
    return scene;
}

Scene slideToRoll() {
    const Material material{.density = discDensity(1, rollerRadius), .friction = 0.2};
    return {
        .name = "slide_to_roll",
        .question = "When and at what speed does a disc roll that is thrown sliding along the floor at 3 m/s?",
        .duration = 3,
        .bodies = {{"floor", {.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0}, material)}}},
                   {"disc",
                    {.position = {-4, rollerRadius}, .velocity = {3, 0}, .shapes = {circle(rollerRadius, material)}}}},
        .closedForm = ClosedForm{.formula = "v = v0 - mu g t until t = v0 / (3 mu g), then 2 v0 / 3",
                                 .source = "textbook: Coulomb's law of friction; Coriolis",
                                 .bodies = {FreeMotion{"disc"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"disc"}, .unit = "rad"}},
        .checks = {ExactCheck{1e-3, sinksOnGround +
                                        "half of it under a disc; friction brakes a little less while the floor finds "
                                        "the load, and then for good"},
                   invariant("probe.angle", 1e-3 / rollerRadius, "the limit of the way, over the radius")},
    };
}

}  // namespace plumb::compare
