// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

/// How fast what is on an incline of 30 degrees gains speed at first [m/s^2].
double gainOf(const Scene& scene) {
    return flightsIn(scene, 0).at(0).acceleration.norm();
}

double blockGain(double friction) {
    Scene scene = findScene("block_slides").value();
    for (SceneBody& body : scene.bodies)
        for (ShapeDef& shape : body.def.shapes) shape.material.friction = friction;
    return gainOf(scene);
}

/// inertiaRatio: k = I / (m r^2).
double rollerGain(double inertiaRatio) {
    Scene scene = findScene("disc_rolls").value();
    BodyDef& disc = std::ranges::find(scene.bodies, "disc", &SceneBody::name)->def;
    const double radius = std::get<Circle>(disc.shapes.at(0).shape).radius;
    disc.mass = Mass{1, {0, 0}, inertiaRatio * radius * radius};
    return gainOf(scene);
}

}  // namespace

TEST_CASE("a block with a friction of 0.3 on 30 degrees gains 2.3562872367 m/s^2",
          "[compare][closed_form][facts][law]") {
    CHECK(std::abs(blockGain(0.3) - 2.3562872367) < digits);  // Worked numbers of response, incline
}

TEST_CASE("a block on 30 degrees sticks from a friction of 0.5773502692 on", "[compare][closed_form][facts][law]") {
    CHECK(blockGain(0.5773502693) == 0);  // Worked numbers of response, incline: the threshold
    CHECK(blockGain(0.5773502691) > 0);
    CHECK(blockGain(0.7) == 0);
}

TEST_CASE("a disc on 30 degrees gains 3.27 m/s^2, a ring 2.4525, a ball 3.5035714286",
          "[compare][closed_form][facts][law]") {
    CHECK(std::abs(rollerGain(0.5) - 3.27) < digits);  // Worked numbers of response, rolling
    CHECK(std::abs(rollerGain(1) - 2.4525) < digits);
    CHECK(std::abs(rollerGain(0.4) - 3.5035714286) < digits);
}

}  // namespace plumb::compare
