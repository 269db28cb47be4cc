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

double energyOf(const World& world) {
    double energy = 0;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        energy += 0.5 * body.mass() * body.velocity().squaredNorm() +
                  0.5 * body.inertia() * body.angularVelocity() * body.angularVelocity() +
                  body.mass() * g * body.centerOfMass().y();
    }
    return energy;
}

/// 20 links of half a metre from (0, 0), and a load at their end.
struct LoadedChain {
    World world;
    std::vector<JointId> joints;
    BodyId load;
    double linkMass = 0;

    LoadedChain(double loadRatio, const Vec2& along) : world({.sleeping = false}) {
        const double angle = std::atan2(along.y(), along.x());
        BodyId last = world.add({.type = BodyType::Static});
        for (int i = 0; i < 20; ++i) {
            const BodyId link =
                world.add({.position = (0.25 + 0.5 * i) * along,
                           .angle = angle,
                           .shapes = {{.shape = Capsule{{-0.25, 0}, {0.25, 0}, 0.05}, .filter = {.group = -1}}}});
            linkMass = world.body(link).mass();
            joints.push_back(world.join(RevoluteJointDef{.bodyA = last, .bodyB = link, .anchor = 0.5 * i * along}));
            last = link;
        }
        const double mass = loadRatio * linkMass;
        load = world.add({.position = 10.5 * along,
                          .mass = Mass{mass, {0, 0}, 0.1 * mass},
                          .shapes = {{.shape = Circle{0.5}, .filter = {.group = -1}}}});
        joints.push_back(world.join(RevoluteJointDef{.bodyA = last, .bodyB = load, .anchor = 10 * along}));
    }
    double worstError() const {
        double worst = 0;
        for (const JointId joint : joints) worst = std::max(worst, world.joint(joint).error());
        return worst;
    }
};

}  // namespace

TEST_CASE("a chain of 20 links holds a load of a thousand times their mass", "[dynamics][joints]") {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
        INFO("load of " << ratio << " links");
        LoadedChain chain(ratio, {0, -1});
        chain.world.body(chain.load).setVelocity({3, 0});
        const double start = energyOf(chain.world), swing = 0.5 * 9 * (ratio + 20) * chain.linkMass;
        double error = 0, energy = 0;
        for (int tick = 0; tick < 1200; ++tick) {
            chain.world.step(dt);
            // In the first two steps it becomes known how tight it is.
            if (tick > 1) error = std::max(error, chain.worstError());
            energy = std::max(energy, std::fabs(energyOf(chain.world) - start));
        }
        CHECK(error < 1e-3);
        CHECK(energy < 0.05 * swing);
    }
}

TEST_CASE("a double pendulum that turns over keeps its energy to 1 % for 60 s", "[dynamics][joints][law]") {
    World world({.sleeping = false});
    const BodyId base = world.add({.type = BodyType::Static});
    const BodyId upper = world.add({.position = {1, 0}, .shapes = {plumb::box({1, 0.05})}});
    const BodyId lower = world.add({.position = {3, 0}, .shapes = {plumb::box({1, 0.05})}});
    world.join(RevoluteJointDef{.bodyA = base, .bodyB = upper});
    world.join(RevoluteJointDef{.bodyA = upper, .bodyB = lower, .anchor = {2, 0}});
    const double start = energyOf(world), range = world.body(upper).mass() * g * 4;  // 1 m and 3 m down
    double worst = 0;
    for (int tick = 0; tick < 3600; ++tick) {
        world.step(dt);
        worst = std::max(worst, std::fabs(energyOf(world) - start));
    }
    CHECK(worst < 0.01 * range);
}

TEST_CASE("a hundred balls on a hung plate, more than can bounce one by one, bounce all the same",
          "[dynamics][joints]") {
    World world({.sleeping = false});
    const BodyId ground = world.add({.type = BodyType::Static});
    const BodyId plate = world.add({.mass = Mass{1e5, {0, 0}, 1e7}, .shapes = {plumb::box({60, 0.5})}});
    world.join(PrismaticJointDef{.bodyA = ground, .bodyB = plate, .axis = {1, 0}});
    std::vector<BodyId> balls;
    for (int i = 0; i < 100; ++i)
        balls.push_back(world.add({.position = {i - 50.0, 2}, .shapes = {circle(0.3, {.restitution = 0.8})}}));
    const double start = energyOf(world);
    double highest = 0;
    bool came = false;
    for (int tick = 0; tick < 75; ++tick) {
        world.step(dt);
        CHECK(energyOf(world) < start * (1 + 1e-6));
        came = came || world.body(balls[50]).velocity().y() > 1;
        if (came) highest = std::max(highest, world.body(balls[50]).position().y());
    }
    // Fallen by h = 1.2 m, back up by e^2 h; half a step of falling may go astray.
    CHECK(std::fabs(highest - (0.8 + 0.64 * 1.2)) < 0.05);
}

TEST_CASE("a bridge of 30 planks between two banks bears a heavy box at its middle", "[dynamics][joints]") {
    World world;
    const BodyId banks = world.add({.type = BodyType::Static});
    std::vector<JointId> joints;
    BodyId last = banks;
    for (int i = 0; i < 30; ++i) {
        const BodyId plank = world.add({.position = {i + 0.5, 0}, .shapes = {plumb::box({0.5, 0.1}, {.density = 20})}});
        joints.push_back(world.join(RevoluteJointDef{.bodyA = last, .bodyB = plank, .anchor = {double(i), 0}}));
        last = plank;
    }
    joints.push_back(world.join(RevoluteJointDef{.bodyA = last, .bodyB = banks, .anchor = {30, 0}}));
    const BodyId box = world.add({.position = {15, 3}, .shapes = {plumb::box({1, 1}, {.density = 100})}});
    const auto worst = [&] {
        double error = 0;
        for (const JointId joint : joints) error = std::max(error, world.joint(joint).error());
        return error;
    };
    double atLanding = 0, atRest = 0, borne = 0;
    for (int tick = 0; tick < 900; ++tick) {
        world.step(dt);
        (tick < 600 ? atLanding : atRest) = std::max(tick < 600 ? atLanding : atRest, worst());
        if (tick < 600) continue;
        borne += world.joint(joints.back()).reaction().force.y() - world.joint(joints.front()).reaction().force.y();
    }
    CHECK(atLanding < 0.05);  // 400 kg from 2 m, on planks of 4 kg
    CHECK(atRest < 5e-3);
    CHECK(world.body(box).position().y() > 0.8);
    // Both banks together bear all there is: 30 planks of 4 kg and a box of 400 kg.
    CHECK(std::fabs(std::fabs(borne / 300) - 520 * g) < 0.01 * 520 * g);
}

TEST_CASE("more hinges than a body needs share its load, and swing on", "[dynamics][joints]") {
    // A swing on three parallel arms, of which two would do: rows that say what others say.
    World world({.sleeping = false});
    const BodyId beam = world.add({.type = BodyType::Static});
    const Vec2 down(std::sin(1.0), -std::cos(1.0));
    const BodyId seat = world.add({.position = down, .shapes = {plumb::box({1.2, 0.1})}});
    std::vector<JointId> joints;
    for (const double x : {-1.0, 0.0, 1.0}) {
        const BodyId arm =
            world.add({.position = Vec2(x, 0) + 0.5 * down, .angle = 1.0, .shapes = {plumb::box({0.02, 0.5})}});
        joints.push_back(world.join(RevoluteJointDef{.bodyA = beam, .bodyB = arm, .anchor = {x, 0}}));
        joints.push_back(world.join(RevoluteJointDef{.bodyA = arm, .bodyB = seat, .anchor = Vec2(x, 0) + down}));
    }
    double worst = 0;
    const double start = energyOf(world);
    for (int tick = 0; tick < 1200; ++tick) {
        world.step(dt);
        for (const JointId joint : joints) worst = std::max(worst, world.joint(joint).error());
    }
    CHECK(worst < 1e-4);
    CHECK(std::fabs(energyOf(world) - start) < 0.01 * world.body(seat).mass() * g);
}

TEST_CASE("machines are the same to the bit for any number of lanes", "[dynamics][joints]") {
    std::vector<std::uint64_t> hashes;
    for (const int lanes : {1, 4, 8, 16}) {
        World world({.solver = {.lanes = lanes}});
        const BodyId frame = world.add({.type = BodyType::Static});
        std::vector<BodyId> grid;
        for (int i = 0; i < 400; ++i) {
            const Vec2 at(0.5 * (i % 20), -0.5 * (i / 20));
            grid.push_back(world.add({.position = at, .shapes = {{.shape = Circle{0.2}, .filter = {.group = -1}}}}));
            const auto hinge = [&](BodyId other, const Vec2& anchor) {
                world.join(RevoluteJointDef{.bodyA = other, .bodyB = grid.back(), .anchor = anchor});
            };
            if (i % 20 > 0) hinge(grid[grid.size() - 2], at - Vec2(0.25, 0));
            if (i >= 20) hinge(grid[grid.size() - 21], at + Vec2(0, 0.25));
            if (i == 0 || i == 19) hinge(frame, at);
        }
        // Not a hinge, so in another batch.
        world.join(DistanceJointDef{.bodyA = grid[25],
                                    .bodyB = grid[68],
                                    .anchorA = world.body(grid[25]).position(),
                                    .anchorB = world.body(grid[68]).position()});
        world.body(grid[395]).applyImpulse({5, 1});
        for (int tick = 0; tick < 120; ++tick) world.step(dt);
        hashes.push_back(stateHash(world));
    }
    CHECK(std::count(hashes.begin(), hashes.end(), hashes.front()) == 4);
}

TEST_CASE("of five hanging discs one swung sends one out, and two send two", "[dynamics][joints][law]") {
    const double out = 0.5, length = 2, radius = 0.1;
    const double swingLength = length + radius * radius / (2 * length);
    const double period = 2 * 3.14159265358979 * std::sqrt(swingLength / g) * (1 + out * out / 16);
    for (const int swung : {1, 2}) {
        INFO(swung << " swung");
        World world({.sleeping = false});
        const BodyId beam = world.add({.type = BodyType::Static});
        std::vector<BodyId> discs;
        for (int i = 0; i < 5; ++i) {
            const Vec2 pivot(2 * radius * i, 0);
            const double angle = i < swung ? -out : 0;
            discs.push_back(world.add({.position = pivot + length * Vec2(std::sin(angle), -std::cos(angle)),
                                       .shapes = {circle(radius, {.friction = 0, .restitution = 1})}}));
            world.join(RevoluteJointDef{.bodyA = beam, .bodyB = discs.back(), .anchor = pivot});
        }
        const double start = energyOf(world),
                     lift = swung * world.body(discs[0]).mass() * g * length * (1 - std::cos(out));
        double tick = 0;
        for (int swing = 1; swing <= 3; ++swing) {
            // Around the time when those that went out turn back.
            std::vector<double> farthest(5, 0.0);
            for (; tick * dt < (0.5 * swing + 0.2) * period; ++tick) {
                world.step(dt);
                if (tick * dt < (0.5 * swing - 0.2) * period) continue;
                for (std::size_t i = 0; i < 5; ++i) {
                    const Vec2 hung = world.body(discs[i]).position() - Vec2(2 * radius * static_cast<double>(i), 0);
                    farthest[i] = std::max(farthest[i], std::fabs(std::atan2(hung.x(), -hung.y())));
                }
            }
            for (int i = 0; i < 5; ++i) {
                INFO("swing " << swing << ", disc " << i + 1);
                const bool goes = swing % 2 == 1 ? i >= 5 - swung : i < swung;
                CHECK(std::fabs(farthest[static_cast<std::size_t>(i)] - (goes ? out : 0)) < 0.02 * out);
            }
        }
        CHECK(std::fabs(energyOf(world) - start) < 0.01 * lift);
    }
}

TEST_CASE("thirty cradles side by side pass an impact on as one does", "[dynamics][joints][law]") {
    const double out = 0.5, length = 2, radius = 0.1;
    World world({.sleeping = false});
    const BodyId beam = world.add({.type = BodyType::Static});
    std::vector<BodyId> discs;
    for (int i = 0; i < 150; ++i) {
        const Vec2 pivot(2 * radius * (i % 5) + 10 * (i / 5), 0);
        const double angle = i % 5 == 0 ? -out : 0;
        discs.push_back(world.add({.position = pivot + length * Vec2(std::sin(angle), -std::cos(angle)),
                                   .shapes = {circle(radius, {.friction = 0, .restitution = 1})}}));
        world.join(RevoluteJointDef{.bodyA = beam, .bodyB = discs.back(), .anchor = pivot});
    }
    std::vector<double> farthest(discs.size(), 0.0);
    for (int tick = 0; tick < 100; ++tick) {  // 1.67 s: the last discs go out and turn back
        world.step(dt);
        for (std::size_t i = 0; i < discs.size(); ++i) {
            const double x = world.body(discs[i]).position().x() - 0.2 * static_cast<double>(i % 5) -
                             10 * static_cast<double>(i / 5);
            if (tick > 55) farthest[i] = std::max(farthest[i], std::fabs(x) / length);
        }
    }
    for (std::size_t i = 0; i < discs.size(); ++i) {
        INFO("disc " << i % 5 + 1 << " of cradle " << i / 5 + 1);
        CHECK(std::fabs(farthest[i] - (i % 5 == 4 ? std::sin(out) : 0.0)) < 0.02 * out);
    }
}
