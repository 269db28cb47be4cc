// SPDX-License-Identifier: MIT
// What holds where loads are far larger than the weight of what carries them?
#include <algorithm>
#include <cmath>
#include <random>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
using namespace plumb;
using namespace plumb::test;

namespace {

/// How far a box sinks into a light platform that a motor without limit moves [m]. ratio: of their masses.
double sunkIntoLift(double ratio, double speed, double rate, double size) {
    World world({.sleeping = false});
    const BodyId ground = world.add({.type = BodyType::Static});
    const BodyId platform = world.add({.shapes = {box({size, 0.1 * size}, {.density = 100})}});
    world.join(PrismaticJointDef{
        .bodyA = ground, .bodyB = platform, .axis = {0, 1}, .motorSpeed = speed, .maxMotorForce = plumb::unlimited});
    const double density = ratio * world.body(platform).mass() / (size * size);
    const BodyId load =
        world.add({.position = {0, 0.6 * size}, .shapes = {box({0.5 * size, 0.5 * size}, {.density = density})}});
    double sunk = 0;
    for (int tick = 0; tick < 2 * rate; ++tick) {
        world.step(1 / rate);
        sunk = std::max(sunk, 0.6 * size - (world.body(load).position().y() - world.body(platform).position().y()));
    }
    return sunk;
}

/// The same of a light piston on a crank that a motor without limit turns.
double sunkIntoPiston(double ratio, double speed, double rate) {
    World world({.sleeping = false});
    const BodyId ground = world.add({.type = BodyType::Static});
    const BodyId piston = world.add({.shapes = {box({1, 0.1}, {.density = 100})}});
    world.join(PrismaticJointDef{.bodyA = ground, .bodyB = piston, .axis = {0, 1}});
    const Vec2 pivot(0, -2.2), pin(0.5, -2.2), middle = 0.5 * pin;
    const auto part = [&](const Vec2& at, plumb::Shape shape) {
        return world.add(
            {.position = at, .shapes = {{.shape = shape, .material = {.density = 50}, .filter = {.mask = 0}}}});
    };
    const BodyId crank = part(pivot, plumb::Circle{0.5});
    const BodyId rod = part(middle, plumb::Circle{0.4});
    world.join(RevoluteJointDef{
        .bodyA = ground, .bodyB = crank, .anchor = pivot, .motorSpeed = speed, .maxMotorTorque = plumb::unlimited});
    world.join(RevoluteJointDef{.bodyA = crank, .bodyB = rod, .anchor = pin});
    world.join(RevoluteJointDef{.bodyA = rod, .bodyB = piston, .anchor = Vec2(0, 0)});
    const double density = ratio * world.body(piston).mass();
    const BodyId load = world.add({.position = {0, 0.6}, .shapes = {box({0.5, 0.5}, {.density = density})}});
    double sunk = 0;
    for (int tick = 0; tick < 2 * rate; ++tick) {
        world.step(1 / rate);
        sunk = std::max(sunk, 0.6 - (world.body(load).position().y() - world.body(piston).position().y()));
    }
    return sunk;
}

/// Does a spring of this frequency pull a body through a wall? Its target is 1 to 10 m behind it, and jumps.
bool isPulledThrough(unsigned seed, double frequency) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
    };
    const double size = std::exp(between(std::log(0.05), 0)), wall = std::exp(between(std::log(0.05), 0));
    const double behind = 0.5 * wall + between(1, 10);
    World world({.sleeping = false});
    world.add({.type = BodyType::Static, .shapes = {box({0.5 * wall, 50})}});
    BodyDef def{.position = {-0.5 * wall - size * between(2, 4.5), between(-1, 1)}, .angle = between(-3, 3)};
    if (seed % 3 == 0) def.shapes = {circle(size)};
    if (seed % 3 == 1) def.shapes = {box({size, size * between(0.3, 1)})};
    if (seed % 3 == 2)
        for (const double x : {-0.6, 0.6}) def.shapes.push_back({.shape = plumb::Circle{0.4 * size, {x * size, 0}}});
    const BodyId body = world.add(def);
    TargetJointDef drag{.body = body,
                        .anchor = def.position + size * Vec2(between(-0.5, 0.5), between(-0.5, 0.5)),
                        .target = Vec2(behind, between(-3, 3)),
                        .spring = plumb::springOf(frequency, 0.7, world.body(body).mass())};
    const JointId joint = world.join(drag);
    for (int tick = 1; tick <= 180; ++tick) {
        world.step(dt);
        if (world.body(body).position().x() > 0) return true;
        if (tick % 20 != 0) continue;
        drag = std::get<TargetJointDef>(world.joint(joint).def());
        drag.target = Vec2(behind, between(-5, 5));
        world.joint(joint).set(drag);
    }
    return false;
}

}  // namespace

TEST_CASE("a box pressed by 100 to 100,000 times its weight rests", "[dynamics][contacts]") {
    for (const int subSteps : {2, 4, 8})
        for (const double rate : {60.0, 240.0})
            for (const double times : {1e2, 1e3, 3e3, 1e4, 3e4, 1e5}) {
                CAPTURE(subSteps, rate, times);
                World world({.gravity = {0, -9.81 * times}, .sleeping = false, .solver = {.subSteps = subSteps}});
                world.add({.type = BodyType::Static, .position = {0, -5}, .shapes = {box({20, 5})}});
                const BodyId pressed = world.add({.position = {0, 2}, .shapes = {box({2, 2})}});
                for (int tick = 0; tick < rate; ++tick) world.step(1 / rate);
                CHECK(world.body(pressed).position().y() > 1);
                CHECK(std::fabs(world.body(pressed).velocity().y()) < 1e-2);
            }
}

TEST_CASE("a lift under 100 to 10,000 times its mass sinks in by less than 3 mm", "[dynamics][joints][machines]") {
    for (const double ratio : {100.0, 300.0, 1000.0, 3000.0, 10000.0})
        for (const double speed : {-1.0, 0.0, 1.0})
            for (const double rate : {30.0, 60.0, 240.0}) {
                CAPTURE(ratio, speed, rate);
                for (const double size : {0.2, 1.0, 5.0}) CHECK(sunkIntoLift(ratio, speed, rate, size) < 3e-3);
                CHECK(sunkIntoPiston(ratio, speed, rate) < 3e-3);
            }
}

TEST_CASE("a mouse spring of 15 to 50 Hz pulls no body through a wall", "[dynamics][joints][walls]") {
    for (const double frequency : {15.0, 30.0, 50.0}) {
        int passed = 0;
        for (unsigned seed = 0; seed < 200; ++seed) passed += isPulledThrough(seed, frequency) ? 1 : 0;
        CAPTURE(frequency);
        CHECK(passed == 0);
    }
}
