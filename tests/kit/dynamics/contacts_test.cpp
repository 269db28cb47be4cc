// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// A thing on a plane at 30 degrees: how far it strays in two seconds from sliding down with an acceleration.
double inclineError(double acceleration, ShapeDef shape, const Material& material) {
    const double tilt = std::numbers::pi / 6;
    const Vec2 up(-std::sin(tilt), std::cos(tilt)), down(-std::cos(tilt), -std::sin(tilt));
    World world({.gravity = {0, -g}});
    world.add({.type = BodyType::Static, .position = -0.5 * up, .angle = tilt, .shapes = {box({50, 0.5}, material)}});
    shape.material = material;
    const BodyId body = world.add({.position = 0.5 * up, .angle = tilt, .shapes = {shape}});
    double worst = 0;
    for (int tick = 1; tick <= 120; ++tick) {
        world.step(1.0 / 60);
        const double t = tick / 60.0;
        const Vec2 truth = 0.5 * up + down * (0.5 * acceleration * t * t);
        worst = std::max(worst, (world.body(body).position() - truth).norm());
    }
    return worst;
}

}  // namespace

// Second order in the step: what is left is the depth to which a soft contact sags, here 0.04 mm, and what that takes
// of a rolling radius of half a metre over a way of 6.5 m.
TEST_CASE("a block with mu 0.3 slides down 30 degrees at 2.3563 m/s^2 within 0.1 mm", "[dynamics][law]") {
    CHECK(inclineError(2.3562872367, box({0.5, 0.5}), {.friction = 0.3}) < 1e-4);
}

TEST_CASE("a block with mu 0.7 stays on 30 degrees within 0.1 mm", "[dynamics][law]") {
    CHECK(inclineError(0, box({0.5, 0.5}), {.friction = 0.7}) < 1e-4);
}

TEST_CASE("a disc rolls down 30 degrees at 3.27 m/s^2 within 0.2 mm", "[dynamics][law]") {
    CHECK(inclineError(3.27, circle(0.5), {.friction = 0.8}) < 2e-4);
}

TEST_CASE("in a stack of ten 1 kg boxes the i-th contact from above carries i times 9.81 N", "[dynamics][law]") {
    World world({.gravity = {0, -g}});
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 10; ++i) boxes.push_back(world.add({.position = {0, 0.5 + i}, .shapes = {box({0.5, 0.5})}}));
    const auto check = [&] {
        for (int i = 0; i < 10; ++i) {
            double force = 0;
            for (const Contact& contact : world.body(boxes[static_cast<std::size_t>(i)]).contacts()) {
                if (contact.shapeB.body != boxes[static_cast<std::size_t>(i)]) continue;
                for (const ContactPoint& point : contact.points) force += point.normalForce;
            }
            INFO("box " << i);
            CHECK(std::fabs(force - (10 - i) * g) < 0.02 * g);
        }
    };
    for (int tick = 0; tick < 300; ++tick) world.step(1.0 / 60);
    check();
    CHECK_FALSE(world.body(boxes[0]).awake());
}

TEST_CASE("ten boxes stand for a minute without sleep, 1 cm off at most, and sink 2 cm in all", "[dynamics]") {
    World world({.gravity = {0, -g}, .sleeping = false});
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 10; ++i) boxes.push_back(world.add({.position = {0, 0.5 + i}, .shapes = {box({0.5, 0.5})}}));
    for (int tick = 0; tick < 3600; ++tick) world.step(1.0 / 60);
    const Vec2 top = world.body(boxes[9]).position();
    CHECK(std::fabs(top.x()) < 1e-2);
    CHECK(top.y() > 9.5 - 20e-3);  // 0.3 mm for each box that a contact carries, 55 in all
    CHECK(top.y() < 9.5 + 1e-3);
}
