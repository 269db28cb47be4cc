// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double hillLength = 10;     // from top to top [m]
constexpr double hillHeight = 1;      // from valley to top [m]
constexpr double pieceLength = 0.05;  // of the chain [m]
constexpr int pieces = 1000;

/// Hills with their tops at x = 0, 10, 20, ...; from right to left, for engines whose chains are solid on one side.
std::vector<Vec2> hills() {
    std::vector<Vec2> points;
    for (int i = pieces; i >= 0; --i) {
        const double x = pieceLength * i - 5;
        points.push_back({x, hillHeight / 2 * (1 + direction(degrees(360) * x / hillLength).x())});
    }
    return points;
}

/// A body starts on the top of a hill at 2 m/s and goes through four valleys. Its lowest point is `under` below its
/// origin. At 5 m/s it moves 81 mm in a step, over ground with a curvature of up to 0.2 / m.
Scene acrossHills(const ShapeDef& shape, double under) {
    return {
        .duration = 12,
        .bodies = {{"hills", {.type = BodyType::Static, .shapes = {chain(hills(), shape.material)}}},
                   {"body", {.position = {0, hillHeight + under}, .velocity = {2, 0}, .shapes = {shape}}}},
    };
}

constexpr Material smooth{.friction = 0};

/// A flat side lands anew on each piece, and loses the energy of its rotation: on the 100 pieces of a hill's top up to
/// I (v / R)^2 / 2 each, with R = 5 m. I is the mass times 0.04 m^2 for a box, and times 0.09 m^2 for the capsule.
const std::string landsAnew =
    "a flat side lands anew on each of 100 pieces of a top, and loses its rotation each time: up to ";
const std::string corners = "in a step its flat side of 0.5 m turns by 16 mrad before the next check: 4 mm at an end";

}  // namespace

Scene terrainBox() {
    Scene scene = acrossHills(box({0.25, 0.25}, smooth), 0.25);
    scene.name = "terrain_box";
    scene.question = "Does a box keep its energy as it slides over hills made of 1,000 pieces?";
    scene.checks = {invariant("energy_drift", 0.12, landsAnew + "3 % of the energy, four times"),
                    invariant("penetration_max", 4e-3, corners)};
    return scene;
}

Scene terrainDisc() {
    Scene scene = acrossHills(circle(0.25), 0.25);
    scene.name = "terrain_disc";
    scene.question = "Does a disc keep its energy as it rolls over hills made of 1,000 pieces?";
    scene.bodies[1].def.angularVelocity = -scene.bodies[1].def.velocity.x() / 0.25;
    scene.checks = {invariant("energy_drift", 0.065,
                              "the slope of the ground is checked once a step of up to 81 mm: it loses the speed into "
                              "the ground that this makes, 1.6 % of the energy a hill, four times"),
                    invariant("penetration_max", 1e-3,
                              "in one step of 81 mm the ground rises by 0.7 mm before the contact is found anew")};
    return scene;
}

Scene terrainCapsule() {
    Scene scene = acrossHills(capsule({-0.25, 0}, {0.25, 0}, 0.25, smooth), 0.25);
    scene.name = "terrain_capsule";
    scene.question = "Does a capsule keep its energy as it slides over hills made of 1,000 pieces?";
    scene.checks = {invariant("energy_drift", 0.2, landsAnew + "6 % of the energy, four times"),
                    invariant("penetration_max", 4e-3, corners)};
    return scene;
}

}  // namespace plumb::compare
