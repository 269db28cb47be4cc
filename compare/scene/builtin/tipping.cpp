// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

const Vec2 blockHalf(0.25, 0.5);                     // of the block [m]
constexpr double tippingAngle = 0.4636476090008061;  // atan(1/2), 26.565 degrees [rad]

/// A block of 1 kg, 0.5 m wide and 1 m high, stands on a slope that goes down to the right. Its lower corner is at
/// (0, 0); it cannot slide.
Scene tippingBlock(double slope) {
    const Vec2 downhill = direction(-slope);
    const Vec2 start = -blockHalf.x() * downhill + blockHalf.y() * perp(downhill);
    const Material rough{.density = 1 / (4 * blockHalf.prod()), .friction = 1};
    return {
        .bodies = {{"incline", {.type = BodyType::Static, .shapes = {segment(-3 * downhill, 3 * downhill, rough)}}},
                   {"block", {.position = start, .angle = -slope, .shapes = {box(blockHalf, rough)}}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"block"}, .unit = "rad"}},
    };
}

}  // namespace

Scene tipBelow() {
    Scene scene = tippingBlock(tippingAngle - degrees(0.5));
    scene.name = "tip_below";
    scene.question = "Does a block stand on a slope half a degree under its tipping angle?";
    scene.duration = 5;
    scene.closedForm = ClosedForm{
        .formula = "it stands where tan t < w / h", .source = "textbook: statics", .bodies = {FreeMotion{"block"}}};
    scene.checks = {
        ExactCheck{1e-3, sinksOnGround + "8/5 of it under a corner that carries all, 0.1 mm, which turns the block "
                                         "by 0.2 mrad; half a degree is 8.7 mrad"},
        invariant("probe.angle", 1e-3, "five times that turn")};
    return scene;
}

Scene tipAbove() {
    Scene scene = tippingBlock(tippingAngle + degrees(0.5));
    scene.name = "tip_above";
    scene.question = "Does a block fall over on a slope half a degree past its tipping angle?";
    scene.duration = 5;
    scene.probes[0].expected = scene.bodies[1].def.angle - degrees(90);
    scene.probes[0].from = 4;
    scene.closedForm = ClosedForm{.formula =
                                      "sin(t/2) = k sn(w t + K, k), k = sin(t0/2), w^2 = 3 g / (4 l), t from straight "
                                      "down of the lower corner; l to the centre",
                                  .source = "Landau, Lifshitz, Mechanics, section 11: a pendulum that starts on top",
                                  .until = 1.2,
                                  .bodies = {FreeMotion{"block"}}};
    scene.checks = {
        ExactCheck{5e-3,
                   "the corner sinks by 0.1 mm as it comes to carry all, and what moves the block by that moves "
                   "it by cosh(1.2 / 0.28) = 39 times as much after 1.2 s"},
        invariant("probe.angle", 1e-3, "it lies on its long side, two corners 1 m apart sunk below 1 mm"),
        invariant(
            "penetration_max", 0.012,
            "its corners come down at 3 m/s, the speed of a fall from 0.5 m: what they move in a sub-step of 1/240 s"),
        invariant("settle_time", 4,
                  "an angle past the tipping point grows by a factor of e in 0.28 s: from half a degree to 60 "
                  "degrees in 1.3 s; then the block lies")};
    return scene;
}

}  // namespace plumb::compare
