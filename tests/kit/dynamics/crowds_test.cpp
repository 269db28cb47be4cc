// SPDX-License-Identifier: MIT
// Do crowds that bounce obey the laws of impact, and is their work bounded?
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

#include "cases.h"
#include "catch.h"
#include "kit/dynamics/worlds.h"

using namespace plumb;
using namespace plumb::test;

namespace {

double energyOfMotion(const World& world, const std::vector<BodyId>& bodies) {
    double energy = 0;
    for (const BodyId id : bodies) {
        const auto body = world.body(id);
        energy += 0.5 * body.mass() * body.velocity().squaredNorm() +
                  0.5 * body.inertia() * body.angularVelocity() * body.angularVelocity();
    }
    return energy;
}

/// 200 discs of radius 0.1 m on a lattice in a world that wraps, of which they fill 40 %; speeds of 1 m/s in all
/// directions.
struct ElasticGas {
    World world;
    std::vector<BodyId> discs;
};

ElasticGas elasticGas() {
    constexpr int count = 200;
    constexpr double radius = 0.1, filled = 0.4, pi = std::numbers::pi;
    const Material material{.friction = 0, .restitution = 1};
    const double width = std::sqrt(count * pi * radius * radius / filled);
    ElasticGas gas{World({.gravity = {0, 0}, .sleeping = false, .wrap = {.width = width, .height = width}}), {}};
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    Random random(7);
    for (int i = 0; i < count; ++i) {
        const double way = random.uniform(0, 2 * pi);
        gas.discs.push_back(gas.world.add({.position = Vec2(i % columns + 0.5, i / columns + 0.5) * (width / columns),
                                           .velocity = {std::cos(way), std::sin(way)},
                                           .shapes = {circle(radius, material)}}));
    }
    return gas;
}

}  // namespace

TEST_CASE("a gas of elastic discs that fills 40 % of its world loses no energy at 60 Hz", "[dynamics][law]") {
    ElasticGas gas = elasticGas();
    const double start = energyOfMotion(gas.world, gas.discs);
    std::size_t impacts = 0;
    for (int tick = allCases(100 * 60); tick > 0; --tick) {
        gas.world.step(dt);
        impacts += gas.world.contactBegins().size();
    }
    CHECK(impacts > static_cast<std::size_t>(allCases(100'000)));
    CHECK(std::fabs(energyOfMotion(gas.world, gas.discs) / start - 1) < 1e-12);
    for (const BodyId disc : gas.discs) CHECK(gas.world.body(disc).angularVelocity() == 0);
}

TEST_CASE("elastic discs that fill 40 % of their world never overlap", "[dynamics][law]") {
    ElasticGas gas = elasticGas();
    for (int tick = 0; tick < 100; ++tick) {
        gas.world.step(dt);
        for (std::size_t i = 0; i < gas.discs.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Vec2 a = gas.world.body(gas.discs[i]).position(), b = gas.world.body(gas.discs[j]).position();
                REQUIRE(gas.world.wrap().shortest(a, b).norm() > 0.2 - 1e-9);
            }
    }
}

// In a row, each disc stays between its neighbours, whatever hits what. Masses differ by up to 1,000, so light ones
// become much faster than their bounds foresaw.
TEST_CASE("a disc that a heavier one has hit does not fly through the next one", "[dynamics][law]") {
    constexpr int count = 6;
    Random random(11);
    for (int run = cases(2000); run > 0; --run) {
        World world({.gravity = {0, 0}, .sleeping = false});
        std::vector<BodyId> row;
        double x = 0;
        for (int i = 0; i < count; ++i) {
            const double radius = random.uniform(0.1, 0.5), speed = std::pow(10, random.uniform(0, 2.5));
            x += radius;
            row.push_back(world.add(
                {.position = {x, 0},
                 .velocity = {random.uniform(-speed, speed), 0},
                 .shapes = {circle(
                     radius, {.density = std::pow(10, random.uniform(-1.5, 1.5)), .friction = 0, .restitution = 1})}}));
            x += radius + random.uniform(0.01, 1);
        }
        const double energy = energyOfMotion(world, row);
        Vec2 momentum(0, 0);
        for (const BodyId disc : row) momentum += world.body(disc).mass() * world.body(disc).velocity();
        for (int tick = 0; tick < 60; ++tick) {
            world.step(dt);
            for (int i = 1; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                REQUIRE(world.body(row[at - 1]).position().x() < world.body(row[at]).position().x());
            }
        }
        CHECK(std::fabs(energyOfMotion(world, row) / energy - 1) < 1e-9);
        for (const BodyId disc : row) momentum -= world.body(disc).mass() * world.body(disc).velocity();
        CHECK(momentum.norm() < 1e-9 * std::sqrt(energy));
    }
}

TEST_CASE("frictionless discs do not begin to spin when several impacts fall into one step", "[dynamics][law]") {
    constexpr double radius = 0.3;
    World world({.gravity = {0, 0}, .sleeping = false});
    const Material slippery{.friction = 0, .restitution = 1};
    for (const double side : {-5.5, 5.5}) {
        world.add({.type = BodyType::Static, .position = {0, side}, .shapes = {plumb::box({6, 0.5}, slippery)}});
        world.add({.type = BodyType::Static, .position = {side, 0}, .shapes = {plumb::box({0.5, 6}, slippery)}});
    }
    std::vector<BodyId> discs;
    for (int i = 0; i < 20; ++i) {
        const double way = i * 2.399963;
        discs.push_back(world.add({.position = {-4 + (i % 5) * 2.0, -3 + (i / 5) * 2.0},
                                   .velocity = {3 * std::cos(way), 3 * std::sin(way)},
                                   .shapes = {circle(radius, slippery)}}));
    }
    for (int tick = allCases(20'000); tick > 0; --tick) {
        world.step(dt);
        for (const BodyId disc : discs) REQUIRE(world.body(disc).angularVelocity() == 0);
        for (const ContactBegin& begin : world.contactBegins()) {
            const bool atWall = world.body(begin.shapeA.body).mass() == 0 || world.body(begin.shapeB.body).mass() == 0;
            if (atWall) REQUIRE(begin.normal.cwiseAbs().maxCoeff() > 1 - 1e-9);  // straight from a wall to the centre
        }
    }
}

TEST_CASE("what bounces on a conveyor belt is carried by it", "[dynamics][law]") {
    for (const double restitution : {0.0, 0.5}) {
        World world({.gravity = {0, -10}});
        world.add({.type = BodyType::Static,
                   .position = {0, -1},
                   .shapes = {plumb::box({100, 1}, {.friction = 0.2, .surfaceSpeed = 3})}});
        const BodyId box = world.add(
            {.position = {0, 1}, .shapes = {plumb::box({0.2, 0.2}, {.friction = 0.2, .restitution = restitution})}});
        run(world, 3);
        CAPTURE(restitution);
        CHECK(std::fabs(std::fabs(world.body(box).velocity().x()) - 3) < 1e-3);
    }
    // One impact: Coulomb's friction gives f (1 + e) v, against the slip.
    World world({.gravity = {0, 0}});
    const Material belt{.friction = 0.2, .restitution = 0.5, .surfaceSpeed = 3};
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({100, 1}, belt)}});
    const BodyId bouncing = world.add({.position = {0, 1}, .velocity = {0, -2}, .shapes = {circle(0.2, belt)}});
    World still({.gravity = {0, -10}});
    still.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({100, 1}, belt)}});
    const BodyId lying = still.add({.position = {0, 0.2}, .fixedRotation = true, .shapes = {circle(0.2, belt)}});
    run(world, 1);
    run(still, 1);
    CHECK(std::fabs(std::fabs(world.body(bouncing).velocity().x()) - 0.2 * 1.5 * 2) < 1e-12);
    CHECK(world.body(bouncing).velocity().x() * still.body(lying).velocity().x() > 0);  // the same way
}

TEST_CASE("a crowd that is made overlapping and then stirred stays within its walls", "[dynamics][law]") {
    constexpr double radius = 12, pi = std::numbers::pi;
    World world;
    std::vector<Vec2> ring;
    for (int i = 0; i < 180; ++i) ring.push_back(Rot::fromAngle(pi * i / 90) * Vec2(radius, 0));
    world.add({.type = BodyType::Static, .shapes = {loop(ring)}});
    world.add({.type = BodyType::Kinematic, .angularVelocity = 12, .shapes = {plumb::box({0.4, 10}, {.friction = 0})}});
    const Material material{.density = 0.25, .friction = 0.1, .restitution = 0.1};
    const ShapeDef kinds[] = {capsule({-0.25, 0}, {0.25, 0}, 0.25, material), circle(0.35, material),
                              plumb::box({0.35, 0.35}, material)};
    std::vector<BodyId> crowd;
    for (int i = 0; i < 900; ++i) {
        const Vec2 place = 0.4 * Vec2(i % 30 - 14.5, i / 30 - 14.5);
        crowd.push_back(world.add({.position = place, .shapes = {kinds[i % 3]}}));
    }
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    for (const BodyId body : crowd) CHECK(world.body(body).position().norm() < radius);
}

TEST_CASE("a crowd that comes to rest in a pit gains no energy", "[dynamics][law]") {
    World world({.sleeping = false});
    const Material floor{.friction = 0.4}, bouncing{.friction = 0.4, .restitution = 0.5};
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({4, 1}, floor)}});
    for (const double x : {-4.0, 4.0})
        world.add({.type = BodyType::Static, .position = {x, 20}, .shapes = {plumb::box({0.5, 20}, floor)}});
    Random random(3);
    std::vector<BodyId> crowd;
    for (int i = 0; i < 150; ++i)
        crowd.push_back(
            world.add({.position = {-2.7 + 0.6 * (i % 10) + random.uniform(-0.04, 0.04), 1 + 0.6 * (i / 10)},
                       .shapes = {i % 2 == 0 ? circle(0.25, bouncing) : plumb::box({0.25, 0.25}, bouncing)}}));
    const auto energy = [&] {
        double sum = energyOfMotion(world, crowd);
        for (const BodyId body : crowd) sum += world.body(body).mass() * 9.81 * world.body(body).position().y();
        return sum;
    };
    const double start = energy();
    double last = start;
    for (int tick = 0; tick < 300; ++tick) {
        world.step(dt);
        const double now = energy();
        CHECK(now - last < 1e-4 * start);  // bodies that overlap are lifted
        last = now;
    }
}
