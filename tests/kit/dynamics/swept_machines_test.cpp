// SPDX-License-Identifier: MIT
// Machines whose direct solution would take too much work are swept, joint by joint: see joints.md.
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

/// Discs in a grid that touch nothing. Each is hinged to the one at its right and to the one below it.
struct Net {
    std::vector<BodyId> discs;
    std::vector<JointId> hinges;
    int columns = 0;

    Net(World& world, const Vec2& corner, int columnCount, int rows, const Breaking& breaking = {})
        : columns(columnCount) {
        for (int i = 0; i < columns * rows; ++i) {
            const Vec2 at = corner + Vec2(i % columns, -(i / columns));
            discs.push_back(
                world.add({.position = at,
                           .shapes = {{.shape = Circle{0.3}, .material = {.density = 0.3}, .filter = {.mask = 0}}}}));
            const auto hinge = [&](int to, const Vec2& aside) {
                hinges.push_back(world.join(RevoluteJointDef{.bodyA = discs[static_cast<std::size_t>(to)],
                                                             .bodyB = discs.back(),
                                                             .anchor = at + aside,
                                                             .breaking = breaking}));
            };
            if (i % columns > 0) hinge(i - 1, {-0.5, 0});
            if (i >= columns) hinge(i - columns, {0, 0.5});
        }
    }
    BodyId disc(int column, int row) const { return discs[static_cast<std::size_t>(row * columns + column)]; }
};

/// Joints of every kind between 12 planks, which lie in three groups at y = 3.
std::vector<JointId> joinPlanks(World& world, const std::vector<BodyId>& planks) {
    const auto between = [](int i) { return Vec2(-5.5 + i, 3); };
    const auto a = [&](int i) { return planks[static_cast<std::size_t>(i)]; };
    const Spring spring = springOf(4, 0.3, 0.2);
    return {world.join(RevoluteJointDef{.bodyA = a(0),
                                        .bodyB = a(1),
                                        .anchor = between(0),
                                        .limit = Limit{-0.3, 0.3},
                                        .motorSpeed = 2,
                                        .maxMotorTorque = 0.1}),
            world.join(WeldJointDef{.bodyA = a(1), .bodyB = a(2), .anchor = between(1)}),
            world.join(PrismaticJointDef{.bodyA = a(2),
                                         .bodyB = a(3),
                                         .anchor = between(2),
                                         .axis = {1, 0},
                                         .limit = Limit{-0.2, 0.2},
                                         .spring = spring}),
            world.join(RevoluteJointDef{.bodyA = a(3), .bodyB = a(4), .anchor = between(3)}),
            world.join(DistanceJointDef{
                .bodyA = a(4), .bodyB = a(5), .anchorA = between(4) - Vec2(0.2, 0), .anchorB = between(4)}),
            world.join(WheelJointDef{.bodyA = a(6), .bodyB = a(7), .anchor = between(6), .spring = spring}),
            world.join(WeldJointDef{.bodyA = a(7), .bodyB = a(8), .anchor = between(7), .bending = spring}),
            world.join(MotorJointDef{.bodyA = a(8), .bodyB = a(9), .maxForce = 5, .maxTorque = 1}),
            world.join(PulleyJointDef{.bodyA = a(10),
                                      .bodyB = a(11),
                                      .groundA = {4, 6},
                                      .groundB = {5, 6},
                                      .anchorA = {4, 3},
                                      .anchorB = {5, 3}}),
            world.join(TargetJointDef{.body = a(0), .anchor = {-6, 3}, .target = {-6, 4}, .maxForce = 50})};
}

}  // namespace

TEST_CASE("a load at the corner of a net opens its hinges to a bound: not at all where they are few",
          "[dynamics][joints]") {
    for (const int columns : {1, 6, 12}) {
        World world({.sleeping = false});
        Net net(world, {0, 0}, columns, columns == 12 ? 12 : 6);
        const int rows = columns == 12 ? 12 : 6;
        const BodyId beam = world.add({.type = BodyType::Static});
        net.hinges.push_back(world.join(RevoluteJointDef{.bodyA = beam, .bodyB = net.disc(0, 0), .anchor = {0, 0.5}}));
        const BodyId load = world.add({.position = {0, -1.0 * rows}, .mass = Mass{100, {0, 0}, 10}});
        net.hinges.push_back(
            world.join(RevoluteJointDef{.bodyA = net.disc(0, rows - 1), .bodyB = load, .anchor = {0, 0.5 - rows}}));
        const auto widest = [&](int ticks) {
            for (int tick = 0; tick < ticks; ++tick) world.step(dt);
            double open = 0;
            for (const JointId hinge : net.hinges) open = std::max(open, world.joint(hinge).error());
            return open;
        };
        const double early = widest(300), late = widest(900);
        INFO(columns << " columns: " << early << " m after 5 s, " << late << " m after 20 s");
        CHECK((columns == 12 ? early > 1e-4 : early < 1e-5));  // a net of 12 x 12 is swept
        CHECK(late < 1.5 * early + 1e-5);
    }
}

TEST_CASE("swept machines of every joint come to no harm, and to the same bits for 1 and 16 lanes",
          "[dynamics][joints]") {
    std::vector<std::uint64_t> hashes;
    for (const int lanes : {1, 16}) {
        World world({.solver = {.lanes = lanes}});
        const BodyId ground =
            world.add({.type = BodyType::Static, .shapes = {segment({-9, 0}, {9, 0}, {.friction = 0.5})}});
        std::vector<BodyId> planks;
        for (int i = 0; i < 12; ++i)
            planks.push_back(world.add({.position = {-6 + 1.0 * i, 3}, .shapes = {box({0.45, 0.1})}}));
        std::vector<JointId> joints = joinPlanks(world, planks);
        // A net without weight makes one machine of them all, of 121 loops.
        const Net net(world, {-6, 15}, 12, 12);
        for (const BodyId disc : net.discs) world.body(disc).setLinearDamping(1);
        for (const BodyId disc : net.discs) world.body(disc).setGravityScale(0);
        joints.insert(joints.end(), net.hinges.begin(), net.hinges.end());
        for (const int i : {0, 6, 10})
            joints.push_back(world.join(RevoluteJointDef{
                .bodyA = net.disc(i, 11), .bodyB = planks[static_cast<std::size_t>(i)], .anchor = {-6.0 + i, 3.5}}));
        double worst = 0;
        for (int tick = 0; tick < 600; ++tick) {
            world.step(dt);
            for (const JointId joint : joints) worst = std::max(worst, world.joint(joint).error());
        }
        CHECK(world.contains(ground));
        CHECK(worst < 0.05);
        for (const BodyId plank : planks) CHECK(world.body(plank).velocity().norm() < 1);
        hashes.push_back(stateHash(world));
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("swept cloths of rods, ropes, welds and stopped hinges open no more than nets of hinges",
          "[dynamics][joints]") {
    const auto widest = [](int columns, int rows, bool atCorners, auto&& jointOf) {
        World world({.sleeping = false});
        std::vector<BodyId> discs;
        std::vector<JointId> joints;
        for (int i = 0; i < columns * rows; ++i) {
            const int column = i % columns, row = i / columns;
            const bool fixed = row == 0 && (!atCorners || column == 0 || column == columns - 1);
            const Vec2 at(column, -row);
            discs.push_back(world.add({.type = fixed ? BodyType::Static : BodyType::Dynamic,
                                       .position = at,
                                       .shapes = {{.shape = Circle{0.4}, .filter = {.mask = 0}}}}));
            const auto join = [&](int to, const Vec2& there) {
                joints.push_back(world.join(jointOf(discs[static_cast<std::size_t>(to)], discs.back(), there, at)));
            };
            if (column > 0 && (row > 0 || atCorners)) join(i - 1, at - Vec2(1, 0));
            if (row > 0) join(i - columns, at + Vec2(0, 1));
        }
        double open = 0;
        for (int tick = 0; tick < 180; ++tick) {
            world.step(dt);
            for (const JointId joint : joints) open = std::max(open, world.joint(joint).error());
        }
        return open;
    };
    const auto rod = [](BodyId a, BodyId b, const Vec2& from, const Vec2& to) {
        return DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = from, .anchorB = to};
    };
    const auto rope = [](BodyId a, BodyId b, const Vec2& from, const Vec2& to) {
        return DistanceJointDef{
            .bodyA = a, .bodyB = b, .anchorA = from, .anchorB = to, .spring = Spring{0, 0}, .maxLength = 1};
    };
    const auto weld = [](BodyId a, BodyId b, const Vec2& from, const Vec2& to) {
        return WeldJointDef{.bodyA = a, .bodyB = b, .anchor = 0.5 * (from + to)};
    };
    const auto hinge = [](BodyId a, BodyId b, const Vec2& from, const Vec2& to) {
        return RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = 0.5 * (from + to), .limit = Limit{-0.3, 0.3}};
    };
    CHECK(widest(20, 20, false, rod) < 0.005);  // 0.02 when each rod was solved by itself
    CHECK(widest(20, 20, true, rod) < 0.15);    // 0.8 in the first second
    CHECK(widest(20, 20, true, rope) < 0.25);   // 0.8
    CHECK(widest(8, 30, false, weld) < 0.005);  // 0.04
    CHECK(widest(20, 20, true, hinge) < 0.03);  // 1.1
}

TEST_CASE("the hinges of a net bear nothing of a disc that leaves the range of numbers, and do not break of it",
          "[dynamics][joints]") {
    for (const bool isForce : {false, true}) {
        for (const double size : {1e15, 1e20, 1e40, 1e300}) {
            INFO((isForce ? "a force of " : "a speed of ") << size);
            World world({.gravity = {0, 0}});
            const Net net(world, {0, 0}, 6, 6, {.force = 1000, .torque = 1000});
            const BodyId wild = net.disc(2, 3);
            world.step(dt);
            if (isForce)
                world.body(wild).applyForce({size, -size});
            else
                world.body(wild).setVelocity({size, -size});
            for (int tick = 0; tick < 30; ++tick) world.step(dt);
            for (const BodyId disc : net.discs) {
                CHECK(world.body(disc).quarantined() == (disc == wild));
                CHECK(world.body(disc).velocity().norm() < 1e-9);
            }
            for (const JointId hinge : net.hinges) {
                REQUIRE(world.contains(hinge));
                CHECK(world.joint(hinge).reaction().force.norm() < 1e-9);
            }
        }
    }
}

TEST_CASE("swept nets of any width hang with gaps below half a per cent of a link", "[dynamics][joints]") {
    for (const int size : {9, 13, 20, 27, 35}) {
        World world({.sleeping = false});
        const Net net(world, {0, 0}, size, size);
        const BodyId beam = world.add({.type = BodyType::Static});
        std::vector<JointId> hinges = net.hinges;
        for (int column = 0; column < size; ++column)
            if (std::abs(2 * column + 1 - size) <= 3)
                hinges.push_back(world.join(RevoluteJointDef{
                    .bodyA = beam, .bodyB = net.disc(column, 0), .anchor = {static_cast<double>(column), 0.5}}));
        for (int tick = 0; tick < 600; ++tick) world.step(dt);
        double open = 0;
        for (const JointId hinge : hinges) open = std::max(open, world.joint(hinge).error());
        INFO(size << " x " << size << ": " << open << " m");
        CHECK(open < 0.005);
    }
}
