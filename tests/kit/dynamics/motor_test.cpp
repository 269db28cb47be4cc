// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
#include "numbers.h"
using namespace plumb;
using namespace plumb::test;

namespace {

/// Something with its centre at the hinge that a motor turns.
struct MotorWheel {
    World world;
    BodyId axle, wheel;
    JointId joint;
    double angle() const { return world.body(wheel).angle(); }
    double speed() const { return world.body(wheel).angularVelocity(); }
    double torque() const { return world.joint(joint).reaction().torque; }
};

MotorWheel wheelOf(double inertia, double speed, double torque, const Vec2& gravity = {0, 0}) {
    MotorWheel w{World({.gravity = gravity, .sleeping = false}), {}, {}, {}};
    w.axle = w.world.add({.type = BodyType::Static});
    w.wheel = w.world.add({.mass = Mass{1, {0, 0}, inertia}, .shapes = {circle(1)}});
    w.joint = w.world.join(
        RevoluteJointDef{.bodyA = w.axle, .bodyB = w.wheel, .motorSpeed = speed, .maxMotorTorque = torque});
    return w;
}

}  // namespace

// Each of 8 half sub-steps a step rounds a float to 6e-8 of it: after 150 steps 7e-5 of the value at worst.
TEST_CASE("a motor of 2 N m spins a disc of 0.5 kg m^2 up at 4 rad/s^2 to its speed, then gives no more torque",
          "[dynamics][law][motor]") {
    MotorWheel w = wheelOf(0.5, 8, 2);
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
    MotorWheel w = wheelOf(0.5, 1, 2);  // 0.25 s are 15 steps exactly, and 0.26 s are 15.6
    MotorWheel v = wheelOf(0.5, -1.04, 2);
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
    MotorWheel w = wheelOf(0.3, 1000, 1.7);
    for (int tick = 0; tick < 120; ++tick) w.world.step(dt);
    const double energy = 0.5 * 0.3 * w.speed() * w.speed();
    CHECK(std::fabs(1.7 * w.angle() / energy - 1) < 1.2e-4);
    CHECK(std::fabs(w.speed() / (1.7 / 0.3 * 2) - 1) < 6e-5);
}

TEST_CASE("an endless torque gives its speed in the first step, and holds it against 100 N m",
          "[dynamics][law][motor]") {
    for (const double torque : {infinity, 1e300}) {
        MotorWheel w = wheelOf(0.5, 3, torque);
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
    MotorWheel w = wheelOf(0.5, 1, 2);
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
    const BodyId arm = world.add({.position = {1, 0}, .mass = Mass{1, {0, 0}, 0.1}, .shapes = {circle(0.1)}});
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
    const BodyId a = world.add({.mass = Mass{1, {0, 0}, 1}, .shapes = {circle(1)}});
    const BodyId b = world.add({.mass = Mass{2, {0, 0}, 3}, .shapes = {circle(1)}});
    world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .motorSpeed = 4, .maxMotorTorque = 5});
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    // 3 wb + wa = 0, wb - wa = 4
    CHECK(std::fabs(world.body(b).angularVelocity() - 1) < 1e-5);
    CHECK(std::fabs(world.body(a).angularVelocity() + 3) < 1e-5);
}

TEST_CASE("a motor stands still at speed 0: a brake of 2 N m stops 0.5 kg m^2 from 8 rad/s after 2 s and 8 rad",
          "[dynamics][law][motor]") {
    MotorWheel w = wheelOf(0.5, 0, 2);
    w.world.body(w.wheel).setAngularVelocity(8);
    for (int tick = 0; tick < 150; ++tick) w.world.step(dt);
    CHECK(std::fabs(w.speed()) < 1e-6);
    CHECK(std::fabs(w.angle() - 8) < 1e-3);
}

TEST_CASE("a motor that is switched off gives no torque, and its body turns freely", "[dynamics][motor]") {
    MotorWheel w = wheelOf(0.5, 7, 2);
    w.world.joint(w.joint).set(RevoluteJointDef{.bodyA = w.axle, .bodyB = w.wheel, .motorSpeed = 7});
    w.world.body(w.wheel).setAngularVelocity(3);
    for (int tick = 0; tick < 60; ++tick) w.world.step(dt);
    CHECK(std::fabs(w.speed() - 3) < 1e-5);
    CHECK(w.torque() == 0);
}

TEST_CASE("setMotorSpeed does the same, to the last bit, as set with a def of that motorSpeed",
          "[dynamics][joints][motor]") {
    const auto compare = [](auto def) {
        World told({.gravity = {1, -2}});
        def.bodyA = told.add({.type = BodyType::Static});
        def.bodyB = told.add({.position = {0, 2}, .shapes = {circle(0.5), box({1, 0.2})}});
        const JointId joint = told.join(def);
        World set = told;
        for (const double speed : {3.0, -1.5, 0.0, 40.0}) {
            def.motorSpeed = speed;
            told.joint(joint).setMotorSpeed(speed);
            set.joint(joint).set(def);
            for (int tick = 0; tick < 30; ++tick) told.step(dt), set.step(dt);
            CHECK(stateHash(told) == stateHash(set));
            CHECK(std::get<decltype(def)>(told.joint(joint).def()).motorSpeed == speed);
        }
    };
    const Vec2 at(0, 2);
    const Spring soft{50, 5};
    compare(RevoluteJointDef{.anchor = at, .maxMotorTorque = 20});
    compare(PrismaticJointDef{.anchor = at, .maxMotorForce = 20});
    compare(DistanceJointDef{.anchorA = {0, 4}, .anchorB = at, .spring = soft, .maxMotorForce = 20});
    compare(WheelJointDef{.anchor = at, .spring = soft, .maxMotorTorque = 20});
}

TEST_CASE("setMotorSpeed wakes a wheel that a brake has put to sleep", "[dynamics][joints][motor]") {
    World world({.gravity = {0, 0}});
    const BodyId axle = world.add({.type = BodyType::Static}), wheel = world.add({.shapes = {circle(1)}});
    const JointId joint = world.join(RevoluteJointDef{.bodyA = axle, .bodyB = wheel, .maxMotorTorque = 10});
    for (int tick = 0; tick < 60; ++tick) world.step(dt);
    REQUIRE_FALSE(world.body(wheel).awake());
    world.joint(joint).setMotorSpeed(2);
    CHECK(world.body(wheel).awake());
    for (int tick = 0; tick < 60; ++tick) world.step(dt);
    CHECK(std::fabs(world.joint(joint).coordinate().speed - 2) < 1e-4);  // the solver's give of 1e-5
}

TEST_CASE("setMotorSpeed is refused for a joint that has no motorSpeed, by the name of its kind",
          "[dynamics][errors][motor]") {
    World world({.gravity = {0, 0}});
    const BodyId wall = world.add({.type = BodyType::Static});
    const BodyId a = world.add({.position = {0, 2}, .shapes = {circle(0.5)}});
    const BodyId b = world.add({.position = {2, 2}, .shapes = {circle(0.5)}});
    const JointId hinge = world.join(RevoluteJointDef{.bodyA = wall, .bodyB = a, .anchor = {0, 2}});
    const JointId slide = world.join(PrismaticJointDef{.bodyA = wall, .bodyB = b, .anchor = {2, 2}});
    const auto refusalOf = [&](const JointDef& def) -> std::string {
        const JointId joint = world.join(def);
        const std::uint64_t before = stateHash(world);
        try {
            world.joint(joint).setMotorSpeed(1);
        } catch (const std::invalid_argument& refusal) {
            CHECK(stateHash(world) == before);
            return refusal.what();
        }
        return "";
    };
    const std::string wanted = " has no motorSpeed; revolute, prismatic, distance and wheel joints have one";
    const auto textOf = [&](const std::string& kind) { return "Joint.setMotorSpeed: a " + kind + wanted; };
    CHECK(refusalOf(WeldJointDef{.bodyA = a, .bodyB = b, .anchor = {1, 2}}) == textOf("WeldJointDef"));
    CHECK(refusalOf(PulleyJointDef{
              .bodyA = a, .bodyB = b, .groundA = {0, 4}, .groundB = {2, 4}, .anchorA = {0, 2}, .anchorB = {2, 2}}) ==
          textOf("PulleyJointDef"));
    CHECK(refusalOf(GearJointDef{.jointA = hinge, .jointB = slide}) == textOf("GearJointDef"));
    CHECK(refusalOf(MotorJointDef{.bodyA = a, .bodyB = b, .maxForce = 1}) == textOf("MotorJointDef"));
    CHECK(refusalOf(TargetJointDef{.body = a, .anchor = {0, 2}, .target = {1, 1}}) == textOf("TargetJointDef"));
    CHECK(refusalOf(FilterJointDef{.bodyA = a, .bodyB = b}) == textOf("FilterJointDef"));
}
