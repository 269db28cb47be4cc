// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/plumb.h>
#include "catch.h"

using plumb::BodyId;
using plumb::BodyType;
using plumb::JointId;
using plumb::Mass;
using plumb::RevoluteJointDef;
using plumb::Vec2;
using plumb::World;
using plumb::test::containsText;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double dt = 1.0 / 60;

/// Something with its centre at the hinge that a motor turns.
struct Wheel {
    World world;
    BodyId axle, wheel;
    JointId joint;
    double angle() const { return world.body(wheel).angle(); }
    double speed() const { return world.body(wheel).angularVelocity(); }
    double torque() const { return world.joint(joint).reaction().torque; }
};

Wheel wheelOf(double inertia, double speed, double torque, const Vec2& gravity = {0, 0}) {
    Wheel w{World({.gravity = gravity, .sleeping = false}), {}, {}, {}};
    w.axle = w.world.add({.type = BodyType::Static});
    w.wheel = w.world.add({.mass = Mass{1, {0, 0}, inertia}, .shapes = {plumb::circle(1)}});
    w.joint = w.world.join(
        RevoluteJointDef{.bodyA = w.axle, .bodyB = w.wheel, .motorSpeed = speed, .maxMotorTorque = torque});
    return w;
}

}  // namespace

// Each of 8 half sub-steps a step rounds a float to 6e-8 of it: after 150 steps 7e-5 of the value at worst.
TEST_CASE("a motor of 2 N m spins a disc of 0.5 kg m^2 up at 4 rad/s^2 to its speed, then gives no more torque",
          "[dynamics][law][motor]") {
    Wheel w = wheelOf(0.5, 8, 2);
    for (int tick = 1; tick <= 150; ++tick) {
        w.world.step(dt);
        const double t = tick * dt;
        const double truth = std::min(4 * t, 8.0);
        CHECK(std::fabs(w.speed() - truth) < 7e-5 * 8);
        const double turned = t < 2 ? 2 * t * t : 8 + 8 * (t - 2);
        CHECK(std::fabs(w.angle() - turned) < 1e-3);
        if (tick < 120) CHECK(std::fabs(w.torque() - 2) < 1e-5);
        if (tick > 121) CHECK(std::fabs(w.torque()) < 1e-4);
    }
}

TEST_CASE("the step at which a motor reaches its speed ends at that speed, not past it", "[dynamics][law][motor]") {
    Wheel w = wheelOf(0.5, 1, 2);  // 0.25 s are 15 steps exactly, and 0.26 s are 15.6
    Wheel v = wheelOf(0.5, -1.04, 2);
    for (int tick = 1; tick <= 30; ++tick) {
        w.world.step(dt);
        v.world.step(dt);
        CHECK(w.speed() < 1 + 1e-6);
        CHECK(v.speed() > -1.04 - 1e-6);
    }
    CHECK(std::fabs(w.speed() - 1) < 1e-6);
    CHECK(std::fabs(v.speed() + 1.04) < 1e-6);
}

// 960 half sub-steps, each rounding a float to 6e-8 of it: 5.8e-5 at worst, and the energy has the speed twice.
TEST_CASE("the work of a motor is the energy of what it has spun up: T phi = I w^2 / 2", "[dynamics][law][motor]") {
    Wheel w = wheelOf(0.3, 1000, 1.7);
    for (int tick = 0; tick < 120; ++tick) w.world.step(dt);
    const double energy = 0.5 * 0.3 * w.speed() * w.speed();
    CHECK(std::fabs(1.7 * w.angle() / energy - 1) < 1.2e-4);
    CHECK(std::fabs(w.speed() / (1.7 / 0.3 * 2) - 1) < 6e-5);
}

TEST_CASE("an endless torque gives its speed in the first step, and holds it against 100 N m",
          "[dynamics][law][motor]") {
    for (const double torque : {infinity, 1e300}) {
        Wheel w = wheelOf(0.5, 3, torque);
        w.world.step(dt);
        CHECK(std::fabs(w.speed() - 3) < 1e-6);
        CHECK(std::fabs(w.torque() - 0.5 * 3 / dt) < 1e-3);
        for (int tick = 0; tick < 60; ++tick) {
            w.world.body(w.wheel).applyTorque(-100);
            w.world.step(dt);
            CHECK(std::fabs(w.speed() - 3) < 1e-5);
        }
        CHECK(std::fabs(w.torque() - 100) < 1e-2);
    }
}

TEST_CASE("a motor of 2 N m under a load of 3 N m loses speed at (3 - 2) / I", "[dynamics][law][motor]") {
    Wheel w = wheelOf(0.5, 1, 2);
    for (int tick = 1; tick <= 60; ++tick) {
        w.world.body(w.wheel).applyTorque(-3);
        w.world.step(dt);
        CHECK(std::fabs(w.speed() + 2.0 * tick * dt) < 1e-4);
        CHECK(std::fabs(w.torque() - 2) < 1e-5);
    }
}

// The torque is a mean over the step, of an angle that has gone on by half of it: (w dt / 2) m g l = 0.08 N m at most.
TEST_CASE("a motor of endless torque turns an arm at 1 rad/s against m g l cos phi", "[dynamics][law][motor]") {
    World world({.gravity = {0, -10}, .sleeping = false});
    const BodyId wall = world.add({.type = BodyType::Static});
    const BodyId arm = world.add({.position = {1, 0}, .mass = Mass{1, {0, 0}, 0.1}, .shapes = {plumb::circle(0.1)}});
    const JointId joint =
        world.join(RevoluteJointDef{.bodyA = wall, .bodyB = arm, .motorSpeed = 1, .maxMotorTorque = infinity});
    for (int tick = 1; tick <= 360; ++tick) {
        world.step(dt);
        const double angle = tick * dt;
        CHECK(std::fabs(world.body(arm).angle() - angle) < 2e-3);
        CHECK(std::fabs(world.body(arm).angularVelocity() - 1) < 1e-4);
        CHECK((world.body(arm).position() - Vec2(std::cos(angle), std::sin(angle))).norm() < 2e-3);
        if (tick > 1) CHECK(std::fabs(world.joint(joint).reaction().torque - 10 * std::cos(angle - 0.5 * dt)) < 0.1);
    }
}

TEST_CASE("a motor between two free discs turns them against each other, and gives no spin in all",
          "[dynamics][law][motor]") {
    World world({.gravity = {0, 0}});
    const BodyId a = world.add({.mass = Mass{1, {0, 0}, 1}, .shapes = {plumb::circle(1)}});
    const BodyId b = world.add({.mass = Mass{2, {0, 0}, 3}, .shapes = {plumb::circle(1)}});
    world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .motorSpeed = 4, .maxMotorTorque = 5});
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    // 3 wb + wa = 0, wb - wa = 4
    CHECK(std::fabs(world.body(b).angularVelocity() - 1) < 1e-5);
    CHECK(std::fabs(world.body(a).angularVelocity() + 3) < 1e-5);
}

TEST_CASE("a motor stands still at speed 0: a brake of 2 N m stops 0.5 kg m^2 from 8 rad/s after 2 s and 8 rad",
          "[dynamics][law][motor]") {
    Wheel w = wheelOf(0.5, 0, 2);
    w.world.body(w.wheel).setAngularVelocity(8);
    for (int tick = 0; tick < 150; ++tick) w.world.step(dt);
    CHECK(std::fabs(w.speed()) < 1e-6);
    CHECK(std::fabs(w.angle() - 8) < 1e-3);
}

TEST_CASE("a joint without a motor does what it did: no torque, and its body turns freely", "[dynamics][motor]") {
    Wheel w = wheelOf(0.5, 7, 0);
    w.world.body(w.wheel).setAngularVelocity(3);
    for (int tick = 0; tick < 60; ++tick) w.world.step(dt);
    CHECK(std::fabs(w.speed() - 3) < 1e-5);
    CHECK(w.torque() == 0);
}

TEST_CASE("a motor's speed and torque are refused when they are no number, or the torque is negative",
          "[dynamics][errors][motor]") {
    World world;
    const BodyId a = world.add({.type = BodyType::Static});
    const BodyId b = world.add({.shapes = {plumb::circle(1)}});
    const auto join = [&](double speed, double torque) {
        world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .motorSpeed = speed, .maxMotorTorque = torque});
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(join(nan, 1), containsText("RevoluteJointDef.motorSpeed: nan is not finite"));
    CHECK_THROWS_WITH(join(infinity, 1), containsText("RevoluteJointDef.motorSpeed: inf is not finite"));
    CHECK_THROWS_WITH(join(1, nan), containsText("RevoluteJointDef.maxMotorTorque: nan is not finite"));
    CHECK_THROWS_WITH(join(1, -2), containsText("RevoluteJointDef.maxMotorTorque: -2 is negative"));
    CHECK_THROWS_WITH(join(1, -infinity), containsText("RevoluteJointDef.maxMotorTorque: -inf is not finite"));
    CHECK_NOTHROW(join(-1, infinity));
}
