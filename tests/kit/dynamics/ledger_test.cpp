// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/plumb.h>
#include <plumb/record/state_hash.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

World keeping(const Vec2& gravity = {0, -g}, bool sleeping = false) {
    return World({.gravity = gravity, .sleeping = sleeping, .ledger = true});
}

double open(const EnergyLedger& e) {
    return std::fabs(e.stored() - e.gained());
}

/// Bodies that fall, slide, roll, bounce, ride, hang, swing, and are pushed, damped, driven and broken loose.
struct Fair {
    World world;
    std::vector<BodyId> pushed;

    explicit Fair(bool ledger, int lanes) : world({.ledger = ledger, .solver = {.lanes = lanes}}) {
        const BodyId ground = world.add({.type = BodyType::Static,
                                         .shapes = {segment({-30, 0}, {30, 0}, {.friction = 0.5}),
                                                    segment({30, 0}, {30, 9}), segment({-30, 0}, {-30, 9})}});
        const Material bouncy{.restitution = 0.7};
        for (int i = 0; i < 12; ++i) {
            pushed.push_back(world.add({.position = {-20 + 1.5 * i, 2 + 0.4 * i},
                                        .angle = 0.3 * i,
                                        .velocity = {3, 0},
                                        .linearDamping = i % 3 == 0 ? 0.2 : 0,
                                        .shapes = {i % 2 == 0 ? plumb::box({0.5, 0.3}, {.friction = 0.4})
                                                              : circle(0.4, {.rollingResistance = 0.02})}}));
            world.add({.position = {5 + i, 4}, .velocity = {-1, 1}, .shapes = {circle(0.3, bouncy)}});
        }
        world.add(
            {.type = BodyType::Static, .position = {-25, 1}, .shapes = {plumb::box({2, 0.2}, {.surfaceSpeed = 2})}});
        world.add({.position = {-25, 2}, .shapes = {plumb::box({0.3, 0.3})}});
        world.add(
            {.type = BodyType::Kinematic, .position = {25, 1}, .velocity = {0, 0.2}, .shapes = {plumb::box({2, 0.2})}});
        world.add({.position = {25, 2}, .shapes = {plumb::box({0.3, 0.3})}});
        const auto hang = [&](double x) {
            return world.add({.position = {x, 12}, .mass = Mass{1, {0, 0}, 0.1}, .shapes = {circle(0.3)}});
        };
        const BodyId swing = hang(0), wheel = hang(3), sprung = hang(6), weak = hang(9);
        world.join(RevoluteJointDef{.bodyA = ground, .bodyB = swing, .anchor = {2, 13}, .limit = Limit{-0.4, 0.4}});
        world.join(RevoluteJointDef{
            .bodyA = ground, .bodyB = wheel, .anchor = {3, 12}, .motorSpeed = 20, .maxMotorTorque = 0.5});
        world.join(DistanceJointDef{
            .bodyA = ground, .bodyB = sprung, .anchorA = {6, 14}, .anchorB = {6, 12}, .spring = springOf(1, 0.05, 1)});
        world.join(DistanceJointDef{.bodyA = ground,
                                    .bodyB = weak,
                                    .anchorA = {9, 14},
                                    .anchorB = {9, 12},
                                    .spring = springOf(1, 0, 1),
                                    .breaking = {.force = 12}});
    }
    void step(int tick) {
        if (tick % 30 < 10) world.body(pushed[static_cast<std::size_t>(tick / 30) % pushed.size()]).applyForce({20, 5});
        if (tick == 200) world.body(pushed[3]).applyImpulse({0, 4});
        world.step(dt);
    }
};

}  // namespace

TEST_CASE("a block that slides to rest loses its energy to friction, m v^2 / 2", "[dynamics][ledger][law]") {
    World world = keeping();
    world.add({.type = BodyType::Static, .position = {0, -0.5}, .shapes = {plumb::box({100, 0.5}, {.friction = 0.3})}});
    const BodyId block = world.add({.position = {0, 0.2},
                                    .velocity = {6, 0},
                                    .shapes = {plumb::box({0.5, 0.2}, {.density = 5, .friction = 0.3})}});
    const double energy = 0.5 * world.body(block).mass() * 36;
    run(world, 4);
    const EnergyLedger ledger = world.ledger().energy;
    CHECK(std::fabs(ledger.friction + energy) < 2e-3 * energy);
    CHECK(std::fabs(ledger.solver) < 2e-3 * energy);
    CHECK(ledger.damping == 0);
    CHECK(open(ledger) < 1e-9 * energy);
}

TEST_CASE("each bounce of a ball takes 1 - e^2 of what it came with", "[dynamics][ledger][law]") {
    World world = keeping();
    world.add({.type = BodyType::Static, .position = {0, -0.5}, .shapes = {plumb::box({5, 0.5})}});
    const BodyId ball = world.add({.position = {0, 5.5}, .shapes = {circle(0.5, {.restitution = 0.8})}});
    const double mass = world.body(ball).mass();
    double taken = 0, height = 5;
    for (int bounce = 0; bounce < 3; ++bounce) {
        double before = taken;
        while (taken == before) {
            world.step(dt);
            taken = -world.ledger().energy.impacts;
        }
        CHECK(std::fabs((taken - before) - mass * g * height * (1 - 0.64)) < 1e-6);
        height *= 0.64;
    }
    CHECK(world.ledger().energy.friction == 0);
}

TEST_CASE("a motor gives its torque times the angle, and drag and force are told apart", "[dynamics][ledger][law]") {
    World world = keeping({0, 0});
    const BodyId base = world.add({.type = BodyType::Static});
    const BodyId wheel = world.add({.mass = Mass{1, {0, 0}, 0.5}});
    world.join(RevoluteJointDef{.bodyA = base, .bodyB = wheel, .motorSpeed = 1000, .maxMotorTorque = 2});
    const BodyId sled = world.add({.position = {0, 5}, .linearDamping = 0.5, .mass = Mass{2, {0, 0}, 1}});
    double pushed = 0;
    for (int tick = 0; tick < 120; ++tick) {
        const double x = world.body(sled).position().x();
        world.body(sled).applyForce({3, 0});
        world.step(dt);
        pushed += 3 * (world.body(sled).position().x() - x);
    }
    const EnergyLedger ledger = world.ledger().energy;
    CHECK(std::fabs(ledger.motors - 2 * world.body(wheel).angle()) < 1e-4);
    CHECK(std::fabs(ledger.forces - pushed) < 1e-9);
    const double kinetic = 0.5 * 2 * world.body(sled).velocity().squaredNorm();
    CHECK(std::fabs(ledger.damping - (kinetic - pushed)) < 1e-9);
    CHECK(std::fabs(ledger.solver) < 1e-4 * ledger.motors);  // the give of the hinge, 1e-5 of its speed
}

TEST_CASE("a lift gives what it lifts m g h, and a belt what it speeds up", "[dynamics][ledger][law]") {
    World world = keeping();
    world.add(
        {.type = BodyType::Kinematic, .position = {0, -0.5}, .velocity = {0, 0.5}, .shapes = {plumb::box({5, 0.5})}});
    const BodyId box = world.add({.position = {0, 0.5}, .velocity = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    run(world, 4);
    const EnergyLedger lifted = world.ledger().energy;
    CHECK(std::fabs(lifted.drivers - world.body(box).mass() * g * 2) < 0.01 * g);

    World second = keeping();
    second.add({.type = BodyType::Static,
                .position = {0, -0.5},
                .shapes = {plumb::box({50, 0.5}, {.friction = 0.5, .surfaceSpeed = 2})}});
    const BodyId crate = second.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5}, {.friction = 0.5})}});
    run(second, 3);
    REQUIRE(std::fabs(second.body(crate).velocity().x() - 2) < 1e-3);
    // The belt gives m v^2: half of it the crate has, half went to the slip.
    const EnergyLedger carried = second.ledger().energy;
    CHECK(std::fabs(carried.drivers - 4) < 0.02);
    CHECK(std::fabs(carried.friction + 2) < 0.02);
}

TEST_CASE("a spring's energy comes and goes, its damper's goes", "[dynamics][ledger][law]") {
    World world = keeping({0, 0});
    const BodyId base = world.add({.type = BodyType::Static});
    const BodyId body = world.add({.position = {3, 0}, .mass = Mass{1, {0, 0}, 1}});
    world.join(DistanceJointDef{
        .bodyA = base, .bodyB = body, .anchorB = {3, 0}, .length = 2, .spring = springOf(0.5, 0.1, 1)});
    const double start = world.ledger().energy.spring;
    CHECK(std::fabs(start - 0.5 * springOf(0.5, 0, 1).stiffness) < 1e-9);
    run(world, 20);
    const EnergyLedger ledger = world.ledger().energy;
    CHECK(ledger.stored() < 1e-4 * start);
    CHECK(std::fabs(ledger.damping + start) < 2e-3 * start);
    CHECK(std::fabs(ledger.solver) < 2e-3 * start);
}

TEST_CASE("the ground gives a box at rest its weight, step by step", "[dynamics][ledger][law]") {
    World world = keeping();
    world.add({.type = BodyType::Static, .position = {0, -0.5}, .shapes = {plumb::box({5, 0.5})}});
    world.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    run(world, 5);
    const MomentumLedger ledger = world.ledger().momentum;
    CHECK((ledger.gravity - Vec2(0, -g * 5)).norm() < 1e-9);
    CHECK((ledger.ground - Vec2(0, g * 5)).norm() < 1e-3);
    CHECK(ledger.solver.norm() < 1e-3);
    CHECK((ledger.momentum - ledger.gained()).norm() < 1e-9);
}

TEST_CASE("each entry of the ledger is needed for it to close", "[dynamics][ledger]") {
    Fair fair(true, 16);
    double largest = 0;
    for (int tick = 0; tick < 900; ++tick) {
        fair.step(tick);
        const Ledger ledger = fair.world.ledger();
        largest = std::max(largest, std::fabs(ledger.energy.stored()));
        REQUIRE(open(ledger.energy) < 1e-6 * largest);
        REQUIRE((ledger.momentum.momentum - ledger.momentum.gained()).norm() <
                1e-9 * (1 + ledger.momentum.gravity.norm()));
    }
    const Ledger ledger = fair.world.ledger();
    const std::pair<const char*, double EnergyLedger::*> entries[] = {{"edits", &EnergyLedger::edits},
                                                                      {"forces", &EnergyLedger::forces},
                                                                      {"drivers", &EnergyLedger::drivers},
                                                                      {"motors", &EnergyLedger::motors},
                                                                      {"friction", &EnergyLedger::friction},
                                                                      {"impacts", &EnergyLedger::impacts},
                                                                      {"damping", &EnergyLedger::damping},
                                                                      {"breaking", &EnergyLedger::breaking},
                                                                      {"solver", &EnergyLedger::solver},
                                                                      {"kinetic", &EnergyLedger::kinetic},
                                                                      {"gravitational", &EnergyLedger::gravitational},
                                                                      {"spring", &EnergyLedger::spring}};
    for (const auto& [name, entry] : entries) {
        INFO(name);
        EnergyLedger without = ledger.energy;
        without.*entry = 0;
        CHECK(open(without) > 1e-5 * largest);
    }
    const std::pair<const char*, Vec2 MomentumLedger::*> parts[] = {{"edits", &MomentumLedger::edits},
                                                                    {"gravity", &MomentumLedger::gravity},
                                                                    {"forces", &MomentumLedger::forces},
                                                                    {"ground", &MomentumLedger::ground},
                                                                    {"damping", &MomentumLedger::damping}};
    for (const auto& [name, part] : parts) {
        INFO(name);
        CHECK((ledger.momentum.*part).norm() > 1e-3);
    }
    // What was taken was taken, what was given given; and what no law accounts for is little beside it.
    CHECK(ledger.energy.friction < 0);
    CHECK(ledger.energy.impacts < 0);
    CHECK(ledger.energy.damping < 0);
    CHECK(ledger.energy.motors > 0);
    CHECK(std::fabs(ledger.energy.solver) < 0.02 * largest);
    CHECK(ledger.momentum.solver.norm() < 0.01 * ledger.momentum.gravity.norm());
}

TEST_CASE("a world is the same to the bit whether account is kept of it or not", "[dynamics][ledger]") {
    Fair kept(true, 16), wide(false, 16), narrow(false, 1);
    for (int tick = 0; tick < 400; ++tick) {
        kept.step(tick);
        wide.step(tick);
        narrow.step(tick);
    }
    CHECK(stateHash(kept.world) == stateHash(wide.world));
    CHECK(stateHash(kept.world) == stateHash(narrow.world));
}

TEST_CASE("who did not ask for a ledger is told so", "[dynamics][ledger]") {
    const World world;
    CHECK_THROWS_WITH(world.ledger(), containsText("WorldDef.ledger was not set"));
}
