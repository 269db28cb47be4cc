// SPDX-License-Identifier: MIT
#include <games/frame/pose_trail.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games;

namespace {

/// A disc at x, gravity off, that moves at 6 m/s and turns at 3 rad/s: 0.1 m and 0.05 rad a tick.
BodyId addDisc(World& world, double x) {
    return world.add({.position = {x, 1}, .velocity = {6, 0}, .angularVelocity = 3, .shapes = {circle(0.1)}});
}

}  // namespace

TEST_CASE("after a quarter of a tick a body is drawn after a quarter of its way", "[games]") {
    World world({.gravity = {0, 0}});
    const BodyId disc = addDisc(world, 2);
    PoseTrail trail;
    trail.keep(world);
    world.step(1.0 / 60);
    const Transform quarter = trail.pose(world, disc, 0.25);
    // A step of free motion is exact to rounding.
    CHECK_THAT(quarter.position.x(), Catch::Matchers::WithinAbs(2.025, 1e-12));
    CHECK_THAT(quarter.rotation.angle(), Catch::Matchers::WithinAbs(0.0125, 1e-12));
    CHECK(trail.pose(world, disc, 0).position.x() == 2);
    CHECK_THAT(trail.pose(world, disc, 1).position.x(), Catch::Matchers::WithinAbs(2.1, 1e-12));
}

TEST_CASE("a body that crosses the seam of a world of 10 m is drawn on the short way, not across the whole world",
          "[games]") {
    World world({.gravity = {0, 0}, .wrap = {.width = 10}});
    const BodyId disc = addDisc(world, 9.96);
    PoseTrail trail;
    trail.keep(world);
    world.step(1.0 / 60);
    REQUIRE(world.body(disc).position().x() < 1);
    CHECK_THAT(trail.pose(world, disc, 0.5).position.x(), Catch::Matchers::WithinAbs(10.01, 1e-12));
}

TEST_CASE("a new body is drawn where it is, even if it has the slot of a removed one", "[games]") {
    World world({.gravity = {0, 0}});
    PoseTrail trail;
    const BodyId gone = addDisc(world, 0);
    trail.keep(world);
    world.remove(gone);
    const BodyId second = addDisc(world, 5), third = addDisc(world, 7);
    REQUIRE(second.index == gone.index);
    CHECK(trail.pose(world, second, 0.5).position.x() == 5);
    CHECK(trail.pose(world, third, 0.5).position.x() == 7);
}
