// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// A world without sleep, with a base that stays where it is.
struct JointBench {
    World world;
    BodyId base;

    explicit JointBench(const Vec2& gravity = {0, -g}) : world({.gravity = gravity, .sleeping = false}) {
        base = world.add({.type = BodyType::Static});
    }
    BodyId disc(const Vec2& position, double mass = 1, double inertia = 0.1) {
        return world.add({.position = position, .mass = Mass{mass, {0, 0}, inertia}, .shapes = {circle(0.2)}});
    }
    void run(double time) {
        for (int tick = 0; tick < std::lround(time / dt); ++tick) world.step(dt);
    }
    double x(BodyId body) const { return world.body(body).position().x(); }
    double y(BodyId body) const { return world.body(body).position().y(); }
};

/// Steps, and gives the time between the first two upward zero crossings of what is asked, by interpolation.
template <class Value>
double periodOf(World& world, Value&& value) {
    std::vector<double> crossings;
    double before = value();
    for (int tick = 1; crossings.size() < 2 && tick < 6000; ++tick) {
        world.step(dt);
        const double now = value();
        if (before < 0 && now >= 0) crossings.push_back((tick - now / (now - before)) * dt);
        before = now;
    }
    return crossings.size() < 2 ? 0.0 : crossings[1] - crossings[0];
}

}  // namespace

TEST_CASE("a body on a slide of 30 degrees gains g / 2 and does not turn", "[dynamics][joints][law]") {
    JointBench bench;
    const BodyId body = bench.disc({0, 0});
    const Vec2 down(std::cos(-pi / 6), std::sin(-pi / 6));
    const JointId slide =
        bench.world.join(PrismaticJointDef{.bodyA = bench.base, .bodyB = body, .anchor = {0.1, 0.1}, .axis = 3 * down});
    bench.run(2);
    // x = a t^2 / 2; the solver's floats leave some 1e-6 of the way
    CHECK(std::fabs(bench.world.joint(slide).coordinate().value - 0.5 * (g / 2) * 4) < 1e-4);
    CHECK(std::fabs(bench.world.joint(slide).coordinate().speed - g) < 1e-4);
    CHECK((bench.world.body(body).position() - down * g).norm() < 1e-4);
    CHECK(std::fabs(bench.world.body(body).angle()) < 1e-6);
    CHECK(bench.world.joint(slide).error() < 1e-6);
    // What the slide bears is across it, m g cos 30.
    CHECK(std::fabs(bench.world.joint(slide).reaction().force.norm() - g * std::cos(pi / 6)) < 1e-3);
}

TEST_CASE("a slide stops at its limits and moves at its motor's speed", "[dynamics][joints]") {
    JointBench bench;
    const BodyId body = bench.disc({0, 0});
    PrismaticJointDef def{.bodyA = bench.base, .bodyB = body, .axis = {0, 1}, .limit = Limit{-1, 0.5}};
    const JointId slide = bench.world.join(def);
    double lowest = 0;
    for (int tick = 0; tick < 120; ++tick) {
        bench.world.step(dt);
        lowest = std::min(lowest, bench.y(body));
    }
    CHECK(std::fabs(bench.y(body) + 1) < 1e-4);
    CHECK(lowest > -1 - 1e-3);
    CHECK(std::fabs(bench.world.joint(slide).reaction().force.y() - g) < 1e-3);
    def.motorSpeed = 0.25;
    def.maxMotorForce = 20;
    bench.world.joint(slide).set(def);
    bench.run(1);
    // 20 N against 9.81 take it to speed in 0.25 / 10.19 s, in which it loses v^2 / 2 a.
    CHECK(std::fabs(bench.y(body) + 0.75 + 0.0625 / (2 * (20 - g))) < 1e-3);
    CHECK(std::fabs(bench.world.joint(slide).coordinate().speed - 0.25) < 1e-5);
    bench.run(6);
    CHECK(std::fabs(bench.y(body) - 0.5) < 1e-4);  // and no farther
    // The motor pushes with all it has, 20 N, against weight and limit.
    CHECK(std::fabs(bench.world.joint(slide).reaction().force.y() - g) < 1e-3);
}

TEST_CASE("a motor of 5 N cannot lift 1 kg", "[dynamics][joints]") {
    JointBench bench;
    const BodyId body = bench.disc({0, 0});
    bench.world.join(
        PrismaticJointDef{.bodyA = bench.base, .bodyB = body, .axis = {0, 1}, .motorSpeed = 1, .maxMotorForce = 5});
    bench.run(1);
    CHECK(std::fabs(bench.y(body) + 0.5 * (g - 5)) < 1e-4);
}

TEST_CASE("springs of 1 to 20 Hz swing at their own frequency", "[dynamics][joints][law]") {
    for (const double frequency : {1.0, 3.0, 7.0, 20.0}) {
        INFO(frequency << " Hz");
        JointBench bench({0, 0});
        const Spring spring = springOf(frequency, 0, 2);
        const BodyId onRod = bench.disc({2.3, 0}, 2);
        bench.world.join(
            DistanceJointDef{.bodyA = bench.base, .bodyB = onRod, .anchorB = {2.3, 0}, .length = 2, .spring = spring});
        const BodyId onSlide = bench.disc({0.3, 5}, 2);
        bench.world.join(PrismaticJointDef{.bodyA = bench.base, .bodyB = onSlide, .spring = spring, .restShift = -0.3});
        // Many swings, so that a wrong frequency shows: after each whole number of periods it is back.
        const double tick = 1 / (16 * frequency);
        for (int i = 0; i < 16 * 40; ++i) bench.world.step(tick);
        CHECK(std::fabs(bench.x(onRod) - 2.3) < 1e-3);
        CHECK(std::fabs(bench.x(onSlide) - 0.3) < 1e-3);
    }
}

TEST_CASE("a damped spring follows its closed form, under, at and over critical damping", "[dynamics][joints][law]") {
    for (const double z : {0.1, 1.0, 2.5}) {
        INFO("damping ratio " << z);
        JointBench bench({0, 0});
        const BodyId body = bench.disc({3, 0});
        bench.world.join(DistanceJointDef{
            .bodyA = bench.base, .bodyB = body, .anchorB = {3, 0}, .length = 2, .spring = springOf(1, z, 1)});
        // x'' = -w^2 x - 2 z w x', from 1 at rest, by Runge and Kutta in steps far finer
        const double w = 2 * pi;
        double x = 1, v = 0, worst = 0;
        for (int tick = 0; tick < 180; ++tick) {
            for (int i = 0; i < 50; ++i) {
                const double h = dt / 50;
                const auto a = [&](double at, double speed) { return -w * w * at - 2 * z * w * speed; };
                const double v1 = v + 0.5 * h * a(x, v), x1 = x + 0.5 * h * v;
                const double v2 = v + 0.5 * h * a(x1, v1), x2 = x + 0.5 * h * v1;
                const double v3 = v + h * a(x2, v2), x3 = x + h * v2;
                const double a1 = a(x, v), a2 = a(x1, v1), a3 = a(x2, v2), a4 = a(x3, v3);
                x += h / 6 * (v + 2 * v1 + 2 * v2 + v3);
                v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            }
            bench.world.step(dt);
            worst = std::max(worst, std::fabs(bench.x(body) - 2 - x));
        }
        CHECK(worst < 1e-3);  // (c h)^2 / 24, c = 2 z w: 7e-4 of the way at the largest
    }
}

TEST_CASE("a spring without damping keeps its energy to 0.1 % for 20 s", "[dynamics][joints][law]") {
    JointBench bench;
    const BodyId body = bench.disc({0, -2.5});
    const double k = springOf(1.5, 0, 1).stiffness;
    bench.world.join(DistanceJointDef{
        .bodyA = bench.base, .bodyB = body, .anchorB = {0, -2.5}, .length = 2, .spring = Spring{k, 0}});
    const auto energy = [&] {
        const double v = bench.world.body(body).velocity().norm();
        const double stretch = -bench.y(body) - 2;
        return 0.5 * v * v + 0.5 * k * stretch * stretch + g * bench.y(body);
    };
    const double start = energy(), swing = 0.5 * k * 0.25;
    double worst = 0;
    for (int tick = 0; tick < 1200; ++tick) {
        bench.world.step(dt);
        worst = std::max(worst, std::fabs(energy() - start));
    }
    CHECK(worst < 1e-3 * swing);
}

TEST_CASE("springs of any stiffness do not blow up, many on one body neither", "[dynamics][joints]") {
    for (const double stiffness : {1e3, 1e6, 1e9, 1e15}) {
        INFO(stiffness << " N/m");
        JointBench bench;
        std::vector<BodyId> grid;
        for (int i = 0; i < 16; ++i) grid.push_back(bench.disc({0.5 * (i % 4), 0.5 * (i / 4)}));
        for (std::size_t i = 0; i < 16; ++i) {
            for (std::size_t j = i + 1; j < 16; ++j) {
                const Vec2 a = bench.world.body(grid[i]).position(), b = bench.world.body(grid[j]).position();
                if ((b - a).norm() < 0.8)
                    bench.world.join(DistanceJointDef{.bodyA = grid[i],
                                                      .bodyB = grid[j],
                                                      .anchorA = a,
                                                      .anchorB = b,
                                                      .length = 0.9 * (b - a).norm(),
                                                      .spring = Spring{stiffness, 0}});
            }
        }
        bench.run(5);
        for (const BodyId body : grid) {
            CHECK(bench.world.contains(body));
            CHECK_FALSE(bench.world.body(body).quarantined());
            CHECK((bench.world.body(body).position() - Vec2(0.75, 0.75 - 0.5 * g * 25)).norm() < 5);
        }
    }
}

TEST_CASE("a rope of 2 m lets its load fall 2 m, and then holds it", "[dynamics][joints]") {
    JointBench bench;
    const BodyId load = bench.disc({0, -1});
    const JointId rope = bench.world.join(
        DistanceJointDef{.bodyA = bench.base, .bodyB = load, .anchorB = {0, -1}, .spring = Spring{}, .maxLength = 2});
    bench.run(0.25);
    CHECK(std::fabs(bench.y(load) - (-1 - 0.5 * g * 0.0625)) < 1e-5);  // slack: it falls freely
    bench.run(3);
    CHECK(std::fabs(bench.y(load) + 2) < 1e-3);
    CHECK(std::fabs(bench.world.joint(rope).reaction().force.y() - g) < 1e-2);
}

TEST_CASE("two boxes welded end to end hold out level from a wall", "[dynamics][joints][law]") {
    JointBench bench;
    const auto beam = [&](double x) {
        return bench.world.add({.position = {x, 0}, .shapes = {box({0.5, 0.1}, {.density = 10})}});
    };
    const BodyId inner = beam(0.5), outer = beam(1.5);
    const JointId atWall = bench.world.join(WeldJointDef{.bodyA = bench.base, .bodyB = inner});
    const JointId between = bench.world.join(WeldJointDef{.bodyA = inner, .bodyB = outer, .anchor = {1, 0}});
    bench.run(3);
    CHECK(std::fabs(bench.y(outer)) < 1e-4);
    // 2 kg each: the wall bears 4 g, and 2 g at 0.5 m and 2 g at 1.5 m; the joint between them 2 g at 0.5 m.
    CHECK(std::fabs(bench.world.joint(atWall).reaction().force.y() - 4 * g) < 1e-2);
    CHECK(std::fabs(bench.world.joint(atWall).reaction().torque - 4 * g) < 2e-2);
    CHECK(std::fabs(bench.world.joint(between).reaction().torque - g) < 1e-2);
}

TEST_CASE("a soft weld bends by torque over stiffness", "[dynamics][joints][law]") {
    JointBench bench;
    const BodyId beam = bench.world.add({.position = {0.5, 0}, .shapes = {box({0.5, 0.1}, {.density = 10})}});
    const JointId weld = bench.world.join(WeldJointDef{.bodyA = bench.base, .bodyB = beam, .bending = Spring{100, 10}});
    bench.run(10);
    const double bent = bench.world.joint(weld).coordinate().value;
    CHECK(std::fabs(100 * bent + 2 * g * 0.5 * std::cos(bent)) < 0.02);
}

TEST_CASE("a hinge's spring turns it back, and its limits hold it", "[dynamics][joints][law]") {
    JointBench bench({0, 0});
    const BodyId door = bench.world.add({.position = {1, 0}, .mass = Mass{1, {0, 0}, 0.5}});
    RevoluteJointDef def{.bodyA = bench.base, .bodyB = door, .spring = springOf(0.5, 0, 1.5), .restAngle = 0.4};
    const JointId hinge = bench.world.join(def);
    // 1.5 kg m^2 about the hinge at 0.5 Hz: there and back in 2 s.
    const double period = periodOf(bench.world, [&] { return bench.world.joint(hinge).coordinate().value - 0.4; });
    CHECK(std::fabs(period - 2) < 2e-3);
    def.limit = Limit{-0.1, 0.1};
    bench.world.joint(hinge).set(def);
    bench.run(3);
    CHECK(std::fabs(bench.world.joint(hinge).coordinate().value - 0.1) < 1e-3);
}

TEST_CASE("a wheel sinks into its suspension by its load over the stiffness, and rolls freely", "[dynamics][joints]") {
    JointBench bench;
    bench.world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({100, 0.5}, {.friction = 1})}});
    const BodyId car = bench.world.add(
        {.position = {0, 0.6}, .fixedRotation = true, .mass = Mass{10, {0, 0}, 1}, .shapes = {box({0.5, 0.1})}});
    const BodyId wheel = bench.world.add(
        {.position = {0, -0.2}, .mass = Mass{1, {0, 0}, 0.05}, .shapes = {circle(0.3, {.friction = 1})}});
    WheelJointDef def{.bodyA = car, .bodyB = wheel, .anchor = {0, -0.2}, .spring = Spring{1000, 100}};
    const JointId axle = bench.world.join(def);
    bench.run(4);
    CHECK(std::fabs(bench.world.joint(axle).coordinate().value - 10 * g / 1000) < 2e-3);  // the car came down by that
    def.motorSpeed = -10;
    def.maxMotorTorque = 30;
    bench.world.joint(axle).set(def);
    bench.run(4);
    CHECK(std::fabs(bench.world.body(car).velocity().x() - 3) < 0.03);  // rolls: 10 rad/s at 0.3 m
    def.maxMotorTorque = 0;
    bench.world.joint(axle).set(def);
    bench.run(2);
    CHECK(std::fabs(bench.world.body(car).velocity().x() - 3) < 0.05);
}

TEST_CASE("an Atwood machine of 3 kg and 1 kg moves at g / 2", "[dynamics][joints][law]") {
    JointBench bench;
    const BodyId heavy = bench.disc({-1, 0}, 3), light = bench.disc({1, 0}, 1);
    const JointId pulley = bench.world.join(PulleyJointDef{.bodyA = heavy,
                                                           .bodyB = light,
                                                           .groundA = {-1, 10},
                                                           .groundB = {1, 10},
                                                           .anchorA = {-1, 0},
                                                           .anchorB = {1, 0}});
    bench.run(1);
    CHECK(std::fabs(bench.y(heavy) + 0.25 * g) < 1e-4);
    CHECK(std::fabs(bench.y(light) - 0.25 * g) < 1e-4);
    // The rope pulls with 2 m1 m2 g / (m1 + m2) on each.
    CHECK(std::fabs(bench.world.joint(pulley).reaction().force.y() - 1.5 * g) < 1e-3);
}

TEST_CASE("a block and tackle of 2 balances 1 kg with 2 kg, and a rope comes up slack", "[dynamics][joints]") {
    JointBench bench;
    const BodyId one = bench.disc({-1, 0}, 1), two = bench.disc({1, 0}, 2);
    const JointId pulley = bench.world.join(PulleyJointDef{.bodyA = one,
                                                           .bodyB = two,
                                                           .groundA = {-1, 5},
                                                           .groundB = {1, 5},
                                                           .anchorA = {-1, 0},
                                                           .anchorB = {1, 0},
                                                           .ratio = 2});
    bench.run(2);
    CHECK(std::fabs(bench.y(one)) < 1e-4);
    CHECK(std::fabs(bench.y(two)) < 1e-4);
    bench.world.body(one).applyImpulse({0, 5});
    bench.world.step(dt);
    // Thrown up, it flies: nothing pulls it down, and the other falls freely.
    CHECK(std::fabs(bench.world.body(one).velocity().y() - (5 - g * dt)) < 1e-4);
    CHECK(bench.world.joint(pulley).reaction().force.norm() < 1e-6);
}

TEST_CASE("a gear of 2 turns the second wheel back at half the speed", "[dynamics][joints][law]") {
    JointBench bench({0, 0});
    const BodyId first = bench.disc({-1, 0}, 1, 0.1), second = bench.disc({1, 0}, 1, 0.4);
    const JointId a = bench.world.join(RevoluteJointDef{.bodyA = bench.base, .bodyB = first, .anchor = {-1, 0}});
    const JointId b = bench.world.join(RevoluteJointDef{.bodyA = bench.base, .bodyB = second, .anchor = {1, 0}});
    const JointId gear = bench.world.join(GearJointDef{.jointA = a, .jointB = b, .ratio = 2});
    for (int tick = 0; tick < 120; ++tick) {
        bench.world.body(first).applyTorque(1);
        bench.world.step(dt);
    }
    // a + 2 b = 0: torque 1 N m on 0.1 + 0.4 / 4 kg m^2 gives 5 rad/s^2.
    CHECK(std::fabs(bench.world.joint(a).coordinate().value - 0.5 * 5 * 4) < 2e-3);
    CHECK(std::fabs(bench.world.joint(b).coordinate().speed + 5) < 1e-3);
    CHECK(std::fabs(bench.world.joint(gear).coordinate().value) < 1e-5);
    bench.world.remove(a);
    CHECK_FALSE(bench.world.contains(gear));  // it went with what drove it
    CHECK(bench.world.contains(b));
}

TEST_CASE("a rack moves at its pinion's radius times its speed", "[dynamics][joints]") {
    JointBench bench({0, 0});
    const BodyId pinion = bench.disc({0, 1}), rack = bench.disc({0, 0});
    const JointId turning = bench.world.join(RevoluteJointDef{
        .bodyA = bench.base, .bodyB = pinion, .anchor = {0, 1}, .motorSpeed = 3, .maxMotorTorque = 50});
    const JointId sliding = bench.world.join(PrismaticJointDef{.bodyA = bench.base, .bodyB = rack});
    bench.world.join(GearJointDef{.jointA = turning, .jointB = sliding, .ratio = -1 / 0.25});  // radius 0.25 m
    bench.run(2);
    CHECK(std::fabs(bench.world.body(rack).velocity().x() - 0.75) < 1e-3);
    CHECK(std::fabs(bench.x(rack) - 0.25 * bench.world.joint(turning).coordinate().value) < 1e-4);
}

TEST_CASE("a motor joint slows what slides like friction of 4 N, and holds a pose", "[dynamics][joints][law]") {
    JointBench bench({0, 0});
    const BodyId sled = bench.world.add(
        {.position = {0, 0}, .velocity = {3, 4}, .mass = Mass{2, {0, 0}, 0.1}, .shapes = {circle(0.2)}});
    bench.world.join(MotorJointDef{.bodyA = bench.base, .bodyB = sled, .rate = 0, .maxForce = 4});
    bench.run(1);
    CHECK(std::fabs(bench.world.body(sled).velocity().norm() - 3) < 1e-3);  // 5 m/s less 2 m/s^2
    bench.run(2);
    CHECK(bench.world.body(sled).velocity().norm() < 1e-4);
    CHECK((bench.world.body(sled).position() - Vec2(0.6, 0.8) * 6.25).norm() < 1e-3);  // v^2 / 2 a

    const BodyId held = bench.disc({5, 0});
    MotorJointDef def{.bodyA = bench.base, .bodyB = held, .maxForce = 1000, .maxTorque = 1000};
    const JointId hold = bench.world.join(def);
    bench.world.body(held).applyImpulse({2, 1});
    bench.run(3);
    CHECK((bench.world.body(held).position() - Vec2(5, 0)).norm() < 1e-4);
    def.offset = Vec2(6, 1);
    def.angle = 0.5;
    bench.world.joint(hold).set(def);
    bench.run(3);
    CHECK((bench.world.body(held).position() - Vec2(6, 1)).norm() < 1e-4);
    CHECK(std::fabs(bench.world.body(held).angle() - 0.5) < 1e-4);
}

TEST_CASE("a body is dragged to its target, with no more force than allowed", "[dynamics][joints]") {
    JointBench bench({0, 0});
    const BodyId body = bench.disc({0, 0}, 2);
    TargetJointDef def{.body = body, .target = {3, 2}};
    const JointId drag = bench.world.join(def);
    bench.run(3);
    CHECK((bench.world.body(body).position() - Vec2(3, 2)).norm() < 1e-3);
    def.target = {1000, 2};
    def.maxForce = 10;
    bench.world.joint(drag).set(def);
    bench.run(1);
    CHECK(std::fabs(bench.world.body(body).velocity().x() - 5) < 0.1);  // 10 N on 2 kg
}

TEST_CASE("two bodies with a filter joint pass through each other, and fly as they would alone", "[dynamics][joints]") {
    JointBench bench;
    const BodyId a = bench.world.add({.position = {-1, 0}, .velocity = {2, 3}, .shapes = {circle(0.3)}});
    const BodyId b = bench.world.add({.position = {1, 0}, .velocity = {-2, 3}, .shapes = {circle(0.3)}});
    bench.world.join(FilterJointDef{.bodyA = a, .bodyB = b});
    bench.run(1);
    CHECK((bench.world.body(a).position() - Vec2(1, 3 - 0.5 * g)).norm() < 1e-12);
    CHECK((bench.world.body(b).position() - Vec2(-1, 3 - 0.5 * g)).norm() < 1e-12);
}

TEST_CASE("a joint that bears more than 15 N breaks, and says so", "[dynamics][joints]") {
    JointBench bench;
    const BodyId load = bench.disc({0, -1});
    const JointId rod = bench.world.join(
        DistanceJointDef{.bodyA = bench.base, .bodyB = load, .anchorB = {0, -1}, .breaking = {.force = 15}});
    bench.run(1);
    REQUIRE(bench.world.contains(rod));
    bench.world.body(load).applyForce({0, -4});
    bench.world.step(dt);
    REQUIRE(bench.world.contains(rod));  // 13.81 N
    bench.world.body(load).applyForce({0, -6});
    bench.world.step(dt);
    CHECK_FALSE(bench.world.contains(rod));
    REQUIRE(bench.world.jointBreaks().size() == 1);
    CHECK(bench.world.jointBreaks()[0].joint == rod);
    CHECK(std::fabs(bench.world.jointBreaks()[0].force.norm() - (g + 6)) < 1e-2);
    bench.world.step(dt);
    CHECK(bench.world.jointBreaks().empty());
    CHECK(std::fabs(bench.world.body(load).velocity().y() + g * dt) < 1e-3);  // it falls
}

TEST_CASE("a body whose x is locked falls straight down whatever pushes it aside", "[dynamics][joints]") {
    JointBench bench;
    const BodyId body = bench.world.add({.position = {1, 5}, .lockX = true, .shapes = {circle(0.3)}});
    for (int tick = 0; tick < 60; ++tick) {
        bench.world.body(body).applyForce({50, 0});
        bench.world.step(dt);
    }
    CHECK(std::fabs(bench.x(body) - 1) < 1e-5);
    CHECK(std::fabs(bench.y(body) - (5 - 0.5 * g)) < 1e-4);
    CHECK(bench.world.joints().empty());
}
