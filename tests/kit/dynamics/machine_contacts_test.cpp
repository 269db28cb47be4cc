// SPDX-License-Identifier: MIT
// Machines of joints that lie, fall and are driven on what they touch.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// A machine over a floor, and what it has been given.
struct JointMachine {
    World world{{.ledger = true}};
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    explicit JointMachine(double friction = 0.6) {
        world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({1000, 1}, {.friction = friction})}});
    }
    void hinge(const BodyId& a, const BodyId& b, const Vec2& anchor) {
        joints.push_back(world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = anchor}));
    }
    double fastest() const {
        double speed = 0;
        for (const BodyId body : bodies) speed = std::max(speed, world.body(body).velocity().norm());
        return speed;
    }
    double worstError() const {
        double error = 0;
        for (const JointId joint : joints) error = std::max(error, world.joint(joint).error());
        return error;
    }
};

/// A box of a ton on two hinged wheels.
void makeCart(JointMachine& machine, double wheelMass, double drop, double x0 = 0) {
    const double y = 0.25 + drop;
    World& world = machine.world;
    const BodyId chassis = world.add(
        {.position = {x0, y}, .shapes = {{.shape = boxPolygon({1, 0.25}, {0, 0.25}), .material = {.density = 1000}}}});
    machine.bodies.push_back(chassis);
    for (const double x : {-0.9, 0.9}) {
        const double density = wheelMass / (pi * 0.01);
        const BodyId wheel = world.add({.position = {x0 + x, y - 0.15}, .shapes = {circle(0.1, {.density = density})}});
        machine.bodies.push_back(wheel);
        machine.hinge(chassis, wheel, {x0 + x, y - 0.15});
    }
}

/// A hanging chain with a heavy box on its upper end, let fall onto the floor.
void makeHeap(JointMachine& machine, int links, double length, double load, double friction) {
    World& world = machine.world;
    const double top = links * length + 1;
    BodyId last = world.add(
        {.position = {0, top + 0.5}, .shapes = {box({0.4, 0.4}, {.density = load / 0.64, .friction = friction})}});
    machine.bodies.push_back(last);
    for (int i = 0; i < links; ++i) {
        const double x = 0.01 * i, y = top - length * i;
        const BodyId link =
            world.add({.position = {x, y - 0.5 * length},
                       .shapes = {box({0.04, 0.5 * length}, {.density = 1 / (0.08 * length), .friction = friction})}});
        machine.bodies.push_back(link);
        machine.hinge(last, link, {x, y});
        last = link;
    }
}

}  // namespace

TEST_CASE("a cart of a ton on wheels of a kilogram comes to rest", "[dynamics][joints][machines]") {
    for (const double wheel : {0.5, 1.57, 15.0, 60.0}) {
        for (const double drop : {0.0, 0.5, 1.75}) {
            INFO("wheels of " << wheel << " kg, dropped by " << drop << " m");
            JointMachine machine;
            makeCart(machine, wheel, drop);
            const double start = machine.world.ledger().energy.stored();
            double error = 0;
            for (int tick = 0; tick < 180; ++tick) {
                machine.world.step(dt);
                error = std::max(error, machine.worstError());
            }
            CHECK(machine.fastest() < 2e-3);
            CHECK(std::fabs(machine.world.body(machine.bodies[0]).position().y() - 0.25) < 1e-3);
            CHECK(error < 1e-3);
            // The floor stops it somewhere in a sub-step, whose gravity then does other work than it would in flight.
            const double speed = std::sqrt(2 * g * drop), bound = 0.5 * (1000 + 2 * wheel) * g * speed * dt / 4;
            // What is left of the impact in later steps is too slow to count as one.
            CHECK(std::fabs(machine.world.ledger().energy.solver) < bound + 1e-2 * start);
            for (int tick = 0; tick < 120; ++tick) machine.world.step(dt);
            CHECK_FALSE(machine.world.body(machine.bodies[0]).awake());
        }
    }
}

TEST_CASE("any number of carts of a ton come to rest", "[dynamics][joints][machines]") {
    for (const int carts : {9, 20}) {
        JointMachine machine;
        for (int i = 0; i < carts; ++i) makeCart(machine, 1.57, 0.5, 3.0 * i);
        for (int tick = 0; tick < 60; ++tick) machine.world.step(dt);
        CHECK(machine.fastest() < 0.05);
        CHECK(machine.worstError() < 1e-4);
    }
}

TEST_CASE("carts of any weights come to rest on hinges, welds and sprung wheels", "[dynamics][joints][machines]") {
    constexpr int runs = 60;
    int restless = 0, jumping = 0;
    for (int run = 0; run < runs; ++run) {
        std::mt19937 random(static_cast<unsigned>(run));
        std::uniform_real_distribution<double> share(0, 1);
        const double mass = std::pow(10, 1 + 4 * share(random)), wheelMass = 0.05 + 5 * share(random);
        const double load = 0.5 * mass, drop = 2 * share(random), rate = 2 * pi * (1 + share(random));
        JointMachine machine;
        World& world = machine.world;
        const BodyId chassis =
            world.add({.position = {0, drop + 0.6}, .shapes = {box({1, 0.2}, {.density = mass / 0.8})}});
        machine.bodies.push_back(chassis);
        for (const double x : {-0.8, 0.8}) {
            const Vec2 at(x, drop + 0.2);
            const BodyId wheel =
                world.add({.position = at, .shapes = {circle(0.2, {.density = wheelMass / (pi * 0.04)})}});
            machine.bodies.push_back(wheel);
            if (run % 3 == 0)
                machine.hinge(chassis, wheel, at);
            else if (run % 3 == 1)
                world.join(WeldJointDef{.bodyA = chassis, .bodyB = wheel, .anchor = at});
            else
                world.join(WheelJointDef{.bodyA = chassis,
                                         .bodyB = wheel,
                                         .anchor = at,
                                         .axis = {0, 1},
                                         .limit = Limit{-0.1, 0.1},
                                         .spring = Spring{load * rate * rate, load * rate}});
        }
        const double start = world.ledger().energy.stored();
        double most = 0;
        for (int tick = 0; tick < 180; ++tick) {
            world.step(dt);
            most = std::max(most, world.ledger().energy.stored());
        }
        restless += machine.fastest() > 0.05;
        jumping += most > 1.01 * start;
    }
    CHECK(restless <= 4);
    CHECK(jumping <= 1);
}

TEST_CASE("a cart whose wheels have stops and no springs gains no energy when it lands",
          "[dynamics][joints][machines]") {
    constexpr int runs = 60;
    int jumping = 0, rocking = 0;
    for (int run = 0; run < runs; ++run) {
        std::mt19937 random(static_cast<unsigned>(run) + 500);
        std::uniform_real_distribution<double> share(0, 1);
        const double mass = std::pow(10, 1.5 + 2.5 * share(random)), wheelMass = 0.1 + 3 * share(random);
        const double drop = 2 * share(random);
        const int wheels = 2 + run % 4;
        JointMachine machine;
        World& world = machine.world;
        machine.bodies.push_back(
            world.add({.position = {0, drop + 0.6}, .shapes = {box({1.5, 0.2}, {.density = mass / 1.2})}}));
        for (int i = 0; i < wheels; ++i) {
            const Vec2 at(-1.3 + 2.6 * i / (wheels - 1), drop + 0.2);
            machine.bodies.push_back(
                world.add({.position = at, .shapes = {circle(0.2, {.density = wheelMass / (pi * 0.04)})}}));
            const double lower = -0.01 - 0.19 * share(random), upper = 0.01 + 0.19 * share(random);
            world.join(WheelJointDef{.bodyA = machine.bodies[0],
                                     .bodyB = machine.bodies.back(),
                                     .anchor = at,
                                     .axis = {0, 1},
                                     .limit = Limit{lower, upper}});
        }
        const double start = world.ledger().energy.stored();
        double most = 0;
        for (int tick = 0; tick < 300; ++tick) {
            world.step(dt);
            most = std::max(most, world.ledger().energy.stored());
        }
        jumping += most > 1.01 * start;
        // Its wheels are at different heights then, so it may roll.
        for (const BodyId body : machine.bodies) rocking += std::fabs(world.body(body).velocity().y()) > 0.05;
    }
    CHECK(jumping <= 1);
    CHECK(rocking <= 3);
}

TEST_CASE("what lands far away changes no bit of a machine on the ground", "[dynamics][joints][machines]") {
    const auto placesAfter = [](bool others) {
        JointMachine machine;
        makeCart(machine, 1.57, 0.5);
        makeHeap(machine, 10, 0.2, 20, 0.5);
        const std::size_t own = machine.bodies.size();
        for (int i = 0; others && i < 17; ++i) makeCart(machine, 1.57, 0.3, 1000 + 3.0 * i);
        std::vector<double> places;
        for (int tick = 0; tick < 120; ++tick) machine.world.step(dt);
        for (std::size_t i = 0; i < own; ++i) {
            const Body body = machine.world.body(machine.bodies[i]);
            places.insert(places.end(), {body.position().x(), body.position().y(), body.angle()});
        }
        return places;
    };
    CHECK(placesAfter(true) == placesAfter(false));
}

TEST_CASE("hinged pairs thrown at walls fly and hit alike with any number of lanes, and with a ledger",
          "[dynamics][joints][machines]") {
    const auto flightOf = [](int lanes, bool ledger) {
        WorldDef def{.ledger = ledger};
        def.solver.lanes = lanes;
        World world(def);
        for (const double x : {-11.0, 11.0})
            world.add({.type = BodyType::Static, .position = {x, 0}, .shapes = {box({1, 30})}});
        world.add({.type = BodyType::Static, .position = {0, -31}, .shapes = {box({12, 1})}});
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-8, 8), speed(-60, 60);
        std::vector<BodyId> bodies;
        for (int i = 0; i < 19; ++i) {
            const Vec2 at(place(random), 2.0 * i - 18), velocity(speed(random), speed(random));
            for (const double x : {0.0, 0.7})
                bodies.push_back(world.add({.position = at + Vec2(x, 0),
                                            .velocity = velocity,
                                            .angularVelocity = 5.0 * i,
                                            .shapes = {box({0.3, 0.1 + 0.02 * (i % 3)})}}));
            world.join(RevoluteJointDef{
                .bodyA = bodies[bodies.size() - 2], .bodyB = bodies.back(), .anchor = at + Vec2(0.35, 0)});
        }
        std::vector<double> numbers;
        for (int tick = 0; tick < 60; ++tick) {
            world.step(dt);
            for (const ContactHit& hit : world.contactHits())
                numbers.insert(numbers.end(), {hit.point.x(), hit.point.y(), hit.approachSpeed});
        }
        for (const BodyId id : bodies) {
            const Body body = world.body(id);
            numbers.insert(numbers.end(), {body.position().x(), body.position().y(), body.angle()});
        }
        return numbers;
    };
    const std::vector<double> alone = flightOf(1, false);
    CHECK(alone.size() > 300);
    for (const int lanes : {1, 4, 8, 16})
        for (const bool ledger : {false, true}) CHECK(flightOf(lanes, ledger) == alone);
}

TEST_CASE("a chain that falls in a heap under a heavy box gains little energy and comes to rest",
          "[dynamics][joints][machines]") {
    constexpr int runs = 40;
    double gains = 0;
    int restless = 0;
    for (int run = 0; run < runs; ++run) {
        std::mt19937 random(static_cast<unsigned>(run));
        std::uniform_real_distribution<double> share(0, 1);
        const double friction = 0.2 + 0.8 * share(random);
        const double load = std::pow(10, 2.5 * share(random));
        const int links = 5 + static_cast<int>(25 * share(random));
        const double length = 0.1 + 0.3 * share(random);
        JointMachine machine(friction);
        makeHeap(machine, links, length, load, friction);
        const double start = machine.world.ledger().energy.stored();
        double least = start;
        for (int tick = 0; tick < 600; ++tick) {
            machine.world.step(dt);
            const double stored = machine.world.ledger().energy.stored();
            gains = std::max(gains, (stored - least) / start);
            least = std::min(least, stored);
        }
        INFO("run " << run << ": " << links << " links under " << load << " kg");
        CHECK(machine.world.ledger().energy.stored() < 0.5 * start);
        restless += machine.fastest() > 0.05;
    }
    CHECK(gains < 0.25);
    CHECK(restless <= 4);
}

TEST_CASE("a motor with too little torque does not drive a cart up a wall, and one with enough drives it on",
          "[dynamics][joints][machines]") {
    for (const double torque : {50.0, 1e4}) {
        INFO("torque " << torque);
        World world;
        world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({1000, 1}, {.friction = 1})}});
        const BodyId chassis = world.add({.position = {0, 0.4}, .shapes = {box({1, 0.2}, {.density = 250})}});
        for (const double x : {-0.8, 0.8}) {
            const BodyId wheel = world.add(
                {.position = {x, 0.2}, .shapes = {circle(0.2, {.density = 10 / (pi * 0.04), .friction = 1})}});
            world.join(RevoluteJointDef{
                .bodyA = chassis, .bodyB = wheel, .anchor = {x, 0.2}, .motorSpeed = -50, .maxMotorTorque = torque});
        }
        double mass = 0;
        for (const BodyId id : world.bodies())
            mass += world.body(id).type() == BodyType::Dynamic ? world.body(id).mass() : 0;
        for (int tick = 0; tick < 60; ++tick) world.step(dt);
        const double speed = world.body(chassis).velocity().x();
        // Both wheels pull with torque / radius, at most with friction's mu m g; the wheels' own spin takes a part.
        const double wheels = 1 + 2 * 0.5 * 10 / mass;
        const double pull = std::min(2 * torque / 0.2 / mass / wheels, g);
        CHECK(speed <= std::min(pull * 1.02, 10.05));
        CHECK(speed >= std::min(0.9 * pull, 9.0) - 0.1);
    }
}
