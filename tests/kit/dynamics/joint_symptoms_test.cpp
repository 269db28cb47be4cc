// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/plumb.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// Two wheels on a fixed base that is each hinge's bodyB, geared.
struct Gearing {
    World world;
    BodyId base = world.add({.type = BodyType::Static});
    BodyId one = world.add({.position = {-2, 0}, .shapes = {circle(1)}});
    BodyId two = world.add({.position = {2, 0}, .shapes = {circle(1)}});
    JointId hingeOne = world.join(RevoluteJointDef{.bodyA = one, .bodyB = base, .anchor = {-2, 0}});
    JointId hingeTwo = world.join(RevoluteJointDef{.bodyA = two, .bodyB = base, .anchor = {2, 0}});
    JointId gear = world.join(GearJointDef{.jointA = hingeOne, .jointB = hingeTwo});
};

}  // namespace

TEST_CASE(
    "two geared wheels whose hinges have them as bodyA sleep and wake together, and the gear's torque is a number",
    "[dynamics][joints]") {
    Gearing gearing;
    gearing.world.body(gearing.one).sleep();
    CHECK_FALSE(gearing.world.body(gearing.two).awake());
    gearing.world.body(gearing.two).setAngularVelocity(3);
    CHECK(gearing.world.body(gearing.one).awake());
    for (int tick = 0; tick < 30; ++tick) gearing.world.step(dt);
    CHECK(std::isfinite(gearing.world.joint(gearing.gear).reaction().torque));
    CHECK(std::fabs(gearing.world.body(gearing.one).angularVelocity() + 1.5) < 1e-3);
    CHECK(std::fabs(gearing.world.body(gearing.two).angularVelocity() - 1.5) < 1e-3);
}

TEST_CASE("each body that a gear moves names it, and once", "[dynamics][joints]") {
    Gearing gearing;
    const std::vector<JointId> ofOne{gearing.hingeOne, gearing.gear}, ofTwo{gearing.hingeTwo, gearing.gear};
    const std::vector<JointId> ofBase{gearing.hingeOne, gearing.hingeTwo, gearing.gear};
    CHECK(gearing.world.body(gearing.one).joints() == ofOne);
    CHECK(gearing.world.body(gearing.two).joints() == ofTwo);
    CHECK(gearing.world.body(gearing.base).joints() == ofBase);
    gearing.world.remove(gearing.hingeOne);
    CHECK_FALSE(gearing.world.contains(gearing.gear));
    CHECK(gearing.world.body(gearing.one).joints().empty());
    CHECK(gearing.world.body(gearing.base).joints() == std::vector{gearing.hingeTwo});
}

TEST_CASE("a rod bears nothing once the ball that hung on it is made static or disabled", "[dynamics][joints]") {
    for (const bool disabled : {false, true}) {
        World world;
        const BodyId hook = world.add({.type = BodyType::Static, .position = {0, 2}});
        const BodyId ball = world.add({.shapes = {circle(1)}});
        const JointId rod =
            world.join(DistanceJointDef{.bodyA = hook, .bodyB = ball, .anchorA = {0, 2}, .anchorB = {0, 0}});
        for (int tick = 0; tick < 10; ++tick) world.step(dt);
        CHECK(world.joint(rod).reaction().force.y() > 30);
        if (disabled)
            world.body(ball).setEnabled(false);
        else
            world.body(ball).setType(BodyType::Static);
        world.step(dt);
        CHECK(world.joint(rod).reaction().force.isZero(0));
    }
}

TEST_CASE("a ball on a rod swings on when the ball above it goes into quarantine", "[dynamics][joints]") {
    World world;
    const BodyId above = world.add({.position = {0, 0}, .shapes = {circle(0.5)}});
    const BodyId below = world.add({.position = {1, -1}, .shapes = {circle(0.5)}});
    const JointId rod =
        world.join(DistanceJointDef{.bodyA = above, .bodyB = below, .anchorA = {0, 0}, .anchorB = {1, -1}});
    world.step(dt);
    const Vec2 hook = world.body(above).position();
    world.body(above).setVelocity({1e300, 0});
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        REQUIRE(world.joint(rod).reaction().force.allFinite());
        REQUIRE(std::fabs((world.body(below).position() - hook).norm() - std::sqrt(2.0)) < 1e-3);
    }
    CHECK(world.body(above).quarantined());
    CHECK_FALSE(world.body(below).quarantined());
}

TEST_CASE("a ball falls freely while what it hangs on is 1e99 m away, and hangs again when that is back",
          "[dynamics][joints]") {
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
        World world({.ledger = true});
        const BodyId hook = world.add({.type = type});
        const BodyId ball = world.add({.position = {0, -1}, .shapes = {circle(0.5)}});
        const JointId rod = world.join(DistanceJointDef{.bodyA = hook, .bodyB = ball, .anchorB = {0, -1}});
        world.step(dt);
        world.body(hook).setPose({1e99, 1e99}, 0);
        for (int tick = 0; tick < 10; ++tick) world.step(dt);
        CHECK(world.joint(rod).reaction().force.isZero(0));
        CHECK(std::fabs(world.body(ball).velocity().y() + 9.81 * 10 * dt) < 1e-6);
        CHECK(std::isfinite(world.ledger().energy.gained()));
        world.body(hook).setEnabled(true);
        world.body(hook).setPose({0, 0}, 0);
        for (int tick = 0; tick < 120; ++tick) world.step(dt);
        CHECK(std::fabs((world.body(ball).position() - world.body(hook).position()).norm() - 1) < 1e-3);
    }
}

TEST_CASE("the error of a joint is finite while one of its bodies is 1e300 m away", "[dynamics][joints]") {
    World world;
    const BodyId near = world.add({.shapes = {circle(0.5)}});
    const BodyId far = world.add({.position = {3, 0}, .shapes = {circle(0.5)}});
    const JointId hinge =
        world.join(RevoluteJointDef{.bodyA = near, .bodyB = far, .anchor = {1, 0}, .limit = Limit{-1, 1}});
    for (const double x : {1e16, 1e100, 1e160, 1e300}) {
        world.body(far).setPose({x, -x}, 2);
        world.step(dt);
        CAPTURE(x);
        CHECK(std::isfinite(world.joint(hinge).error()));
        CHECK(world.joint(hinge).error() > x);
        CHECK(std::isfinite(world.joint(hinge).angleError()));
    }
}

TEST_CASE(
    "a double pendulum of two points on rods without weight swings alike, and loses nothing, however small they are",
    "[dynamics][joints]") {
    std::vector<double> ends;
    for (const double inertia : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        INFO("inertia " << inertia << " kg m^2");
        World world({.sleeping = false});
        const BodyId ceiling = world.add({.type = BodyType::Static});
        const Mass point{1, {0, 0}, inertia};
        const BodyId upper = world.add({.position = {0.3, -0.95}, .mass = point});
        const BodyId lower = world.add({.position = {0.9, -1.75}, .mass = point});
        const JointId first = world.join(RevoluteJointDef{.bodyA = ceiling, .bodyB = upper, .anchor = {0, 0}});
        const JointId second = world.join(RevoluteJointDef{.bodyA = upper, .bodyB = lower, .anchor = {0.3, -0.95}});
        const auto energy = [&] {
            double sum = 0;
            for (const BodyId body : {upper, lower})
                sum += 0.5 * world.body(body).velocity().squaredNorm() + 9.81 * world.body(body).position().y();
            return sum;
        };
        const double before = energy();
        double gap = 0;
        for (int tick = 0; tick < 120; ++tick) {
            world.step(dt);
            gap = std::max({gap, world.joint(first).error(), world.joint(second).error()});
        }
        CHECK(gap < 1e-5);
        CHECK(std::fabs(energy() - before) < 0.02);
        ends.push_back(world.body(lower).position().x());
    }
    for (const double end : ends) CHECK(std::fabs(end - ends.back()) < 1e-3);
}

TEST_CASE("three welded bars hold while two of them are kept from turning, as they do if their joints are set again",
          "[dynamics][joints]") {
    std::vector<std::uint64_t> states;
    for (const bool again : {false, true}) {
        World world({.sleeping = false});
        std::vector<BodyId> bars;
        std::vector<JointId> welds;
        for (int i = 0; i < 3; ++i) bars.push_back(world.add({.position = {1.0 * i, 0}, .shapes = {box({0.4, 0.1})}}));
        for (std::size_t i = 1; i < 3; ++i)
            welds.push_back(world.join(
                WeldJointDef{.bodyA = bars[i - 1], .bodyB = bars[i], .anchor = {static_cast<double>(i) - 0.5, 0}}));
        for (int tick = 0; tick < 180; ++tick) {
            if (tick == 60) world.body(bars[0]).setFixedRotation(true);
            if (tick == 80) world.body(bars[2]).setFixedRotation(true);
            if (tick == 120) world.body(bars[2]).setFixedRotation(false);
            if (again && tick >= 60) world.joint(welds[0]).set(world.joint(welds[0]).def());
            world.body(bars[1]).applyForce({0.02, 0.1}, world.body(bars[1]).position() + Vec2(0.3, 0));
            world.step(dt);
            for (const JointId weld : welds) CHECK(world.joint(weld).error() < 1e-5);
        }
        states.push_back(stateHash(world));
    }
    CHECK(states[0] == states[1]);
}

TEST_CASE("a bar that is whirled at its end at 50 or 100 rad/s keeps its hinge and its speed for 10 s",
          "[dynamics][joints]") {
    for (const double spin : {50, 100}) {
        INFO(spin << " rad/s");
        World world({.gravity = {0, 0}, .sleeping = false});
        const BodyId ground = world.add({.type = BodyType::Static});
        const BodyId bar = world.add(
            {.position = {0.5, 0}, .velocity = {0, 0.5 * spin}, .angularVelocity = spin, .shapes = {box({0.5, 0.05})}});
        const JointId hinge = world.join(RevoluteJointDef{.bodyA = ground, .bodyB = bar, .anchor = {0, 0}});
        double gap = 0;
        for (int tick = 0; tick < 600; ++tick) {
            world.step(dt);
            gap = std::max(gap, world.joint(hinge).error());
        }
        CHECK(gap < 2e-5);
        CHECK(std::fabs(world.body(bar).angularVelocity() / spin - 1) < 5e-3);
    }
}
