// SPDX-License-Identifier: MIT
#include <compare/metric/mechanics.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

BodyState moving(const Vec2& position, const Vec2& velocity, double spin) {
    return {position, 0, velocity, spin};
}

// Sums of a few products of numbers below 1000: rounding stays under 1e-12.
constexpr double mechanicsRounding = 1e-12;

}  // namespace

TEST_CASE("2 kg at (3, 4) m/s and 6 rad/s, 5 m up, have 29.5 J, 100 J and (6, 8) N s", "[compare][metric]") {
    const MassModel masses(oneDisc());
    const std::vector<BodyState> states{moving({1, 5}, {3, 4}, 6)};
    const Mechanics sum = *masses.at(states);
    CHECK_THAT(sum.kinetic, WithinAbs(2 * 25 / 2.0 + 0.25 * 36 / 2, mechanicsRounding));  // 25 + 4.5
    CHECK_THAT(sum.potential, WithinAbs(2 * 10 * 5, mechanicsRounding));
    CHECK_THAT(sum.lifted, WithinAbs(100, mechanicsRounding));  // from the origin
    CHECK_THAT(sum.momentum.x(), WithinAbs(6, mechanicsRounding));
    CHECK_THAT(sum.momentum.y(), WithinAbs(8, mechanicsRounding));
    CHECK_THAT(sum.momentumSize, WithinAbs(10, mechanicsRounding));
    // about the start (0, 0): 2 (1 * 4 - 5 * 3) + 0.25 * 6
    CHECK_THAT(sum.angularMomentum, WithinAbs(-20.5, mechanicsRounding));
}

TEST_CASE("a gravity scale of 0.5 halves the potential", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.gravityScale = 0.5;
    CHECK_THAT(MassModel(scene).at(std::vector<BodyState>{at(0, 5)})->potential, WithinAbs(50, mechanicsRounding));
}

TEST_CASE("the potential is that of the centre of mass, which a quarter turn lifts by its 0.3 m arm",
          "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.mass = Mass{2, {0.3, 0}, 0.25};
    BodyState turned = at(0, 0);
    turned.angle = 1.5707963267948966;
    const Mechanics sum = *MassModel(scene).at(std::vector<BodyState>{turned});
    CHECK_THAT(sum.lifted, WithinAbs(2 * 10 * 0.3, mechanicsRounding));
}

TEST_CASE("static and kinematic bodies have neither energy nor momentum", "[compare][metric]") {
    Scene scene = oneDisc();
    SceneBody lift = scene.bodies[0];
    lift.name = "lift";
    lift.def.type = BodyType::Kinematic;
    scene.bodies.push_back(lift);
    const MassModel masses(scene);
    const Mechanics sum = *masses.at(std::vector<BodyState>{at(0, 0), moving({0, 3}, {9, 9}, 9)});
    CHECK(sum.kinetic == 0);
    CHECK(sum.potential == 0);
    CHECK(masses.dynamicBodies() == std::vector<std::size_t>{0});
}

TEST_CASE("mechanics of a state that is not a number do not exist", "[compare][metric]") {
    const MassModel masses(oneDisc());
    CHECK_FALSE(masses.at(std::vector<BodyState>{at(nan, 0)}));
    CHECK_FALSE(masses.at(std::vector<BodyState>{at(0, infinity)}));
    CHECK_FALSE(masses.fastestPoint(std::vector<BodyState>{at(nan, 0)}));
}

TEST_CASE("the fastest point of a disc of 0.5 m at 3 m/s and -4 rad/s moves at 5 m/s", "[compare][metric]") {
    const MassModel masses(oneDisc());
    CHECK_THAT(*masses.fastestPoint(std::vector<BodyState>{moving({0, 0}, {0, 3}, -4)}),
               WithinAbs(5, mechanicsRounding));
}

TEST_CASE("the far corner of a box of 3 m by 4 m at 2 rad/s moves at 5 m/s", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.shapes = {box({1.5, 2})};
    const MassModel masses(scene);
    CHECK_THAT(*masses.fastestPoint(std::vector<BodyState>{moving({0, 0}, {0, 0}, 2)}),
               WithinAbs(5, mechanicsRounding));
}

TEST_CASE("a capsule 4 m long and a rounded box with corners 2 m out, both of radius 0.5 m, reach 2.5 m",
          "[compare][metric]") {
    for (const ShapeDef& shape : {capsule({-2, 0}, {2, 0}, 0.5), roundedBox({1.2, 1.6}, 0.5)}) {
        Scene scene = oneDisc();
        scene.bodies[0].def.shapes = {shape};
        const double speed = *MassModel(scene).fastestPoint(std::vector<BodyState>{moving({0, 0}, {0, 0}, 2)});
        CHECK_THAT(speed, WithinAbs(2 * (2 + 0.5), mechanicsRounding));
    }
}

TEST_CASE("a spring of 8 N/m that is 0.5 m too long holds 1 J, and none once it has broken", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies.push_back({"post", {.type = BodyType::Static}});
    scene.joints = {{"spring", "post", "disc", DistanceJointDef{.length = 1, .spring = Spring{8, 0}}}};
    const std::vector<BodyState> states{at(1.5, 0), at(0, 0)};
    CHECK_THAT(MassModel(scene).at(states)->elastic, WithinAbs(1, mechanicsRounding));
    CHECK(MassModel(scene).at(states, {true})->elastic == 0);
}

}  // namespace plumb::compare
