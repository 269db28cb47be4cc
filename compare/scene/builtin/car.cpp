// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double wheelRadius = 0.4;
constexpr double bodyMass = 40, wheelMass = 4;
constexpr double wheelSpeed = 6;                            // the speed that the motors try to reach [m/s]
constexpr double suspension = 3000;                         // of each spring [N/m]
constexpr double level = 25, hillsBegin = 55, finish = 90;  // where the ground changes [m]

/// Level, then waves 10 m long that go up and down by half a metre, then level.
ShapeDef ground() {
    std::vector<Vec2> points{{finish, 0}};
    for (double x = hillsBegin; x > level; x -= 0.5)
        points.push_back({x, 0.25 * (1 - sinCos(2 * std::numbers::pi * (x - level) / 10).cos)});
    points.push_back({level, 0});
    points.push_back({-10, 0});
    return chain(points, {.friction = 0.9});  // from right to left: solid from above
}

void addWheel(Scene& scene, const std::string& name, double x) {
    const Vec2 hub(x, wheelRadius);
    scene.bodies.push_back(
        {name,
         {.position = hub,
          .canSleep = false,
          .shapes = {circle(wheelRadius, {.density = discDensity(wheelMass, wheelRadius), .friction = 0.9})}}});
    const double damping = 2 * 0.5 * std::sqrt(suspension * bodyMass / 2);
    scene.joints.push_back({name + "_suspension", "body", name,
                            WheelJointDef{.anchor = hub,
                                          .axis = {0, 1},
                                          .limit = Limit{-0.25, 0.25},
                                          .spring = Spring{suspension, damping},
                                          .motorSpeed = -wheelSpeed / wheelRadius,
                                          .maxMotorTorque = 60}});
}

}  // namespace

Scene carOverHills() {
    const Vec2 start(0, 0.9);
    Scene scene{
        .name = "car_over_hills",
        .question = "Does a car on springs keep the pace of its motors on the level, and come over the hills?",
        .duration = 14,
        .bodies = {{"ground", {.type = BodyType::Static, .shapes = {ground()}}},
                   {"body",
                    {.position = start, .canSleep = false, .shapes = {box({1.2, 0.25}, {.density = bodyMass / 1.2})}}}},
    };
    addWheel(scene, "rear", start.x() - 0.8);
    addWheel(scene, "front", start.x() + 0.8);
    const Probe pace{.name = "pace",
                     .quantity = VelocityProbe{"body", {1, 0}},
                     .expected = wheelSpeed,
                     .from = 3,
                     .unit = "m/s",
                     .until = 3.5};
    Probe paceAfter = pace;
    paceAfter.name = "pace_after";
    paceAfter.from = 13;
    paceAfter.until = 14;
    const double sag = bodyMass * gravity / (2 * suspension);
    scene.probes = {pace,
                    paceAfter,
                    {.name = "ride_height",
                     .quantity = PositionProbe{"body", {0, 1}},
                     .expected = start.y() - sag,
                     .from = 3,
                     .unit = "m",
                     .until = 3.5}};
    scene.checks = {
        invariant("probe.pace", 0.01 * wheelSpeed, "1 % of r w: nothing holds it back on the level"),
        invariant("probe.pace_after", 0.01 * wheelSpeed, "1 % of r w, three seconds after the last hill"),
        invariant("probe.ride_height", 2e-3, "each spring carries half of the body: m g / (2 k) = 65 mm"),
        invariant("joint_error_max", 5e-3, "across the suspension, and beyond its ends, at 6 m/s over hills"),
        invariant("penetration_max", 1e-2, "wheels on the ground"),
    };
    return scene;
}

}  // namespace plumb::compare
