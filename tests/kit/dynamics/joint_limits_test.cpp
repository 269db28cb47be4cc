// SPDX-License-Identifier: MIT
// What happens at each limit of joints, and beyond it? The limits are on kit/plumb/dynamics/limits.md.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"

using plumb::BodyId;
using plumb::BodyType;
using plumb::JointId;
using plumb::Vec2;
using plumb::World;
using plumb::test::dt;
using plumb::test::steps;

namespace {

/// The widest gap, in a second, of a square net that hangs at one corner [m].
double gapOfNet(int size) {
    World world({.sleeping = false});
    const BodyId beam = world.add({.type = BodyType::Static});
    std::vector<BodyId> discs;
    std::vector<JointId> hinges;
    const auto hinge = [&](BodyId a, const Vec2& anchor) {
        hinges.push_back(world.join(plumb::RevoluteJointDef{.bodyA = a, .bodyB = discs.back(), .anchor = anchor}));
    };
    for (int i = 0; i < size * size; ++i) {
        const Vec2 at(i % size, -(i / size));
        discs.push_back(world.add({.position = at, .shapes = {{.shape = plumb::Circle{0.3}, .filter = {.mask = 0}}}}));
        if (i == 0) hinge(beam, at + Vec2(0, 0.5));
        if (i % size > 0) hinge(discs[static_cast<std::size_t>(i - 1)], at - Vec2(0.5, 0));
        if (i >= size) hinge(discs[static_cast<std::size_t>(i - size)], at + Vec2(0, 0.5));
    }
    double gap = 0;
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        for (const JointId one : hinges) gap = std::max(gap, world.joint(one).error());
    }
    return gap;
}

/// How far the last of some hanging discs that touch goes out when the first has swung by 0.3 rad, as a share of that.
double passedOn(int count) {
    const double out = 0.3, length = 2, radius = 0.1;
    World world({.sleeping = false});
    const BodyId beam = world.add({.type = BodyType::Static});
    BodyId last;
    for (int i = 0; i < count; ++i) {
        const Vec2 pivot(2 * radius * i, 0);
        const double angle = i == 0 ? -out : 0;
        last = world.add({.position = pivot + length * Vec2(std::sin(angle), -std::cos(angle)),
                          .shapes = {plumb::circle(radius, {.friction = 0, .restitution = 1})}});
        world.join(plumb::RevoluteJointDef{.bodyA = beam, .bodyB = last, .anchor = pivot});
    }
    double farthest = 0;
    for (int tick = 0; tick < 110; ++tick) {
        world.step(dt);
        const Vec2 hung = world.body(last).position() - Vec2(2 * radius * (count - 1), 0);
        farthest = std::max(farthest, std::atan2(hung.x(), -hung.y()));
    }
    return farthest / out;
}

/// At which frequency a body swings on a spring, with sub-steps of 1/240 s [Hz].
double frequencyOf(double wanted) {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = {.subSteps = 1}});
    const BodyId wall = world.add({.type = BodyType::Static});
    const BodyId body = world.add({.position = {0.01, 0}, .mass = plumb::Mass{1, {0, 0}, 1}});
    world.join(plumb::PrismaticJointDef{.bodyA = wall,
                                        .bodyB = body,
                                        .anchor = {0.01, 0},
                                        .axis = {1, 0},
                                        .spring = plumb::springOf(wanted, 0, 1),
                                        .restShift = -0.01});
    int passes = 0;
    double last = 1;
    for (int tick = 0; tick < 2400; ++tick) {
        world.step(1.0 / 240);
        const double x = world.body(body).position().x();
        if (x * last < 0) ++passes;
        last = x;
    }
    return passes / 20.0;
}

/// By how much a cart so many times as heavy as each of its two wheels sinks into the ground [m].
double cartSinks(double ratio) {
    World world({.sleeping = false});
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({60, 1})}});
    const BodyId cart =
        world.add({.position = {0, 0.6}, .mass = plumb::Mass{ratio, {0, 0}, ratio}, .shapes = {plumb::box({1, 0.2})}});
    for (const double x : {-0.8, 0.8}) {
        const BodyId wheel =
            world.add({.position = {x, 0.3}, .mass = plumb::Mass{1, {0, 0}, 0.045}, .shapes = {plumb::circle(0.3)}});
        world.join(plumb::RevoluteJointDef{.bodyA = cart, .bodyB = wheel, .anchor = {x, 0.3}});
    }
    steps(world, 240);
    return 0.6 - world.body(cart).position().y();
}

/// What a bar that is whirled around its end, so far in a sub-step, has left of its speed after a second.
double whirledKeeps(double turn) {
    const double spin = 4 * turn / dt;
    World world({.gravity = {0, 0}, .sleeping = false});
    const BodyId ground = world.add({.type = BodyType::Static});
    const BodyId bar = world.add({.position = {0.5, 0},
                                  .velocity = {0, 0.5 * spin},
                                  .angularVelocity = spin,
                                  .shapes = {plumb::box({0.5, 0.05})}});
    world.join(plumb::RevoluteJointDef{.bodyA = ground, .bodyB = bar, .anchor = {0, 0}});
    steps(world, 60);
    return world.body(bar).angularVelocity() / spin;
}

/// The widest gap of the hinge of a bar that is whirled at a wall, so far in a sub-step [m].
double gapAtWall(double turn) {
    double gap = 0;
    for (int place = 0; place < 12; ++place) {  // where the wall is, so the bar meets it at other times in its sub-step
        const double spin = 4 * turn / dt;
        const plumb::Material material{.friction = 0, .restitution = 0.5};
        World world({.gravity = {0, 0}, .sleeping = false});
        const BodyId wall = world.add({.type = BodyType::Static,
                                       .position = {-0.95 + 0.05 * place, 0},
                                       .shapes = {plumb::box({0.02, 0.5}, material)}});
        const BodyId bar = world.add({.position = {0.5, 0},
                                      .velocity = {0, 0.5 * spin},
                                      .angularVelocity = spin,
                                      .shapes = {plumb::box({0.5, 0.05}, material)}});
        const JointId hinge = world.join(
            plumb::RevoluteJointDef{.bodyA = wall, .bodyB = bar, .anchor = {0, 0}, .collideConnected = true});
        for (int tick = 0; tick < 30; ++tick) {
            world.step(dt);
            gap = std::max(gap, world.joint(hinge).error());
        }
    }
    return gap;
}

}  // namespace

TEST_CASE("a net of 8 x 8 discs holds to 0.01 mm, one of 9 x 9 is swept and opens", "[dynamics][joints][limits]") {
    CHECK(gapOfNet(8) < 1e-5);
    CHECK(gapOfNet(9) > 1e-3);
}

TEST_CASE("a bar whirled by 7 rad in a sub-step keeps its speed, by 10 rad it loses a tenth in a second",
          "[dynamics][joints][limits]") {
    CHECK(std::fabs(whirledKeeps(7) - 1) < 1e-3);  // 16 pieces, in each of which half a radian is predicted: 8 rad
    CHECK(whirledKeeps(10) < 0.9);
}

TEST_CASE("a cradle of 65 discs passes an impact on, one of 66 spreads it", "[dynamics][joints][limits]") {
    CHECK(std::fabs(passedOn(65) - 1) < 0.02);  // 64 contacts
    CHECK(passedOn(66) < 0.2);
}

TEST_CASE("a spring of 55 Hz swings at 55 Hz, one of 70 Hz at 56.2 Hz", "[dynamics][joints][limits]") {
    // In 10 s the passes of the middle are counted to one, which is 0.05 Hz; the first and the last may be cut off.
    CHECK(std::fabs(frequencyOf(55) - 55) < 0.11);
    CHECK(std::fabs(frequencyOf(70) - 1.4706289 * 240 / (2 * std::numbers::pi)) < 0.11);
}

TEST_CASE("a cart of 10,000 times the mass of its wheels sinks in as one of 100 times, of a million times by 2 mm",
          "[dynamics][joints][limits]") {
    CHECK(std::fabs(cartSinks(1e4) - cartSinks(100)) < 1e-6);
    CHECK(cartSinks(1e6) > 1e-3);
}

TEST_CASE("a bar whirled at a wall opens its hinge by less than 1 mm at 0.5 rad in a sub-step, and more at 0.7",
          "[dynamics][joints][limits]") {
    CHECK(gapAtWall(0.5) < 1e-3);
    CHECK(gapAtWall(0.7) > 1e-2);
}
