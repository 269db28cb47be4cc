// SPDX-License-Identifier: MIT
#include <compare/formula/pendulum.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double height = 0.1;         // half of the block's height [m]
constexpr double bulletRadius = 0.05;  // of the bullet [m]
constexpr double inside = 0.4;         // half of the length of the room in the block [m]

/// A block with room for a bullet: a floor, and a wall at either end.
SceneBody woodBlock(double mass) {
    const Material smooth{.friction = 0};
    const ShapeDef floor{boxPolygon({inside + 0.2, 0.05}, {0, -height}), smooth};
    const ShapeDef front{boxPolygon({0.1, height}, {inside + 0.1, 0}), smooth};
    const ShapeDef back{boxPolygon({0.1, height}, {-inside - 0.1, 0}), smooth};
    return {"block", {.canSleep = false, .mass = Mass{mass, {0, 0}, mass / 10}, .shapes = {floor, front, back}}};
}

SceneJoint rod(const std::string& name, const Vec2& hold, double length) {
    return {name, "pivot", "block", DistanceJointDef{.anchorA = hold + Vec2(0, length), .anchorB = hold}};
}

}  // namespace

Scene ballisticPendulum() {
    const BallisticPendulum shot{.bullet = 0.1, .block = 1, .speed = 10, .length = 1, .gravity = gravity};
    const double impact = 3.0 / 60;  // at the end of a step, so that each engine has the impact there [s]
    const Vec2 hit(inside - bulletRadius, 0.05 - height + bulletRadius), approach(shot.speed, 0);
    const Material lead{.density = discDensity(shot.bullet, bulletRadius), .friction = 0};
    const double half = periodOf({shot.length, gravity, amplitudeOf(shot)}) / 2;
    return {
        .name = "ballistic_pendulum",
        .question = "How high does a block of 1 kg on two rods swing that stops 100 g at 10 m/s?",
        .duration = impact + half,
        .bodies = {pivotBody({0, shot.length}),
                   woodBlock(shot.block),
                   {"bullet",
                    {.position = hit - impact * approach,
                     .velocity = approach,
                     .canSleep = false,
                     .shapes = {circle(bulletRadius, lead)}}}},
        .joints = {rod("left_rod", {-inside, 0}, shot.length), rod("right_rod", {inside, 0}, shot.length)},
        .closedForm =
            ClosedForm{.formula = "h = (m v / (m + M))^2 / (2 g), then a pendulum",
                       .source = "Robins 1742: the impact keeps momentum, the swing energy",
                       .bodies = {CaughtMotion{"block", "bullet", "block"}, CaughtMotion{"bullet", "bullet", "block"}}},
        .probes = {{.name = "rise",
                    .quantity = PositionProbe{"block", {0, 1}},
                    .expected = riseOf(shot),
                    .unit = "m",
                    .watch = Watch::Largest}},
        .checks = {ExactCheck{4e-3, "an impact put off by one sub-step of 1/240 s at 0.91 m/s"},
                   invariant("probe.rise", 0.01 * riseOf(shot), "1 % of the rise, half of that of the speed")},
    };
}

}  // namespace plumb::compare
