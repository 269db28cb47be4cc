// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr double halfRoom = 5;  // half of the room's width [m]
constexpr Material elastic{.density = 1, .friction = 0, .restitution = 1};

SceneBody roomWall(const std::string& name, const Vec2& position, const Vec2& halfSize) {
    return {name, {.type = BodyType::Static, .position = position, .shapes = {box(halfSize, elastic)}}};
}

}  // namespace

Scene elasticGas() {
    const double thick = 0.5;
    Scene scene{
        .name = "elastic_gas",
        .question = "Twenty discs bounce about in a closed room for a minute: is their energy kept?",
        .gravity = {0, 0},
        .duration = 60,
        .bodies = {roomWall("wall_left", {-halfRoom - thick, 0}, {thick, halfRoom + 2 * thick}),
                   roomWall("wall_right", {halfRoom + thick, 0}, {thick, halfRoom + 2 * thick}),
                   roomWall("wall_bottom", {0, -halfRoom - thick}, {halfRoom, thick}),
                   roomWall("wall_top", {0, halfRoom + thick}, {halfRoom, thick})},
    };
    // Five by four places of 2 m by 2.5 m. Each disc is somewhere inside its own place, so that none overlap.
    Random random(2);
    for (int i = 0; i < 20; ++i) {
        const double radius = 0.2;
        const Vec2 place(-4 + 2 * (i % 5), -3.75 + 2.5 * (i / 5));
        const double shiftX = random.uniform(-0.6, 0.6), shiftY = random.uniform(-0.8, 0.8);
        const double heading = random.uniform(0, degrees(360));
        const double speed = random.uniform(0.5, 1.5);
        scene.bodies.push_back({"disc_" + std::to_string(i + 1),
                                {.position = place + Vec2(shiftX, shiftY),
                                 .velocity = speed * direction(heading),
                                 .shapes = {circle(radius, elastic)}}});
    }
    scene.checks = {
        AgreeCheck{1e-3, 0.3,
                   "until the first impact all fly straight; an impact at the end of a step instead of "
                   "its own time shifts a disc by up to v dt = 2.5 cm, and chaos does the rest"},
        invariant("energy_drift", 1e-3,
                  "an impact alone keeps the energy to rounding; of some four hundred a few come within a step of "
                  "another on the same disc, and may be solved together with it"),
        invariant("penetration_max", 1e-3, "discs turn round where they touch"),
    };
    return scene;
}

}  // namespace plumb::compare
