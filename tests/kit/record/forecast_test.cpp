// SPDX-License-Identifier: MIT
#include <plumb/record/forecast.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include <plumb/math/random.h>
#include <plumb/record/state_hash.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

namespace {

constexpr double dt = 1.0 / 60;

bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
bool sameBits(const Vec2& a, const Vec2& b) {
    return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y());
}

/// Walls, steps, a swinging gate, a windmill, and loose boxes, some of them asleep.
World playground(Random& random) {
    World world;
    world.add({.type = BodyType::Static,
               .shapes = {{.shape = Chain{{{-20, 30}, {-20, 0}, {0, 0}, {5, 1}, {20, 1}, {20, 30}}},
                           .material = {.restitution = 0.6}}}});
    for (int i = 0; i < 8; ++i) {
        const double half = random.uniform(0.2, 0.6);
        world.add({.position = {random.uniform(-18, 18), random.uniform(2, 12)},
                   .angle = random.uniform(0, 3),
                   .shapes = {box({half, random.uniform(0.2, 0.6)}, {.restitution = random.uniform(0, 0.8)})}});
    }
    world.add({.type = BodyType::Kinematic,
               .position = {3, 8},
               .angularVelocity = 2,
               .shapes = {box({2, 0.1}, {.restitution = 1})}});
    const BodyId gate = world.add({.position = {-6, 9}, .shapes = {box({0.1, 1.5})}});
    const BodyId post = world.add({.type = BodyType::Static, .position = {-6, 10.5}});
    world.join(RevoluteJointDef{.bodyA = post, .bodyB = gate, .anchor = {-6, 10.5}});
    for (int i = random.integer(0, 240); i > 0; --i) world.step(dt);
    return world;
}

/// Wind, a pool, a star that pulls, rough ground and a fan over a part of the place, then half a second in them.
void addFields(World& world, Random& random) {
    world.addField({.law = Drag{.linear = random.uniform(0, 0.1), .wind = {random.uniform(-9, 9), 0}}});
    world.addField({.law = Drag{.quadratic = random.uniform(0, 0.02)}});
    world.addField({.law = Pool{.fluid = {.surface = {0, random.uniform(0, 3)}}}});
    world.addField({.law = Attractor{.center = {8, 2}, .strength = random.uniform(0, 200), .softening = 1}});
    world.addField({.law = GroundFriction{.friction = random.uniform(0, 0.1)}});
    world.addField({.law = UniformGravity{{0, 20}}, .region = boxPolygon({2, 5}, {-10, 10})});
    for (int tick = 0; tick < 30; ++tick) world.step(dt);
}

BodyDef randomShot(Random& random) {
    BodyDef shot{.position = {-17, random.uniform(12, 20)},
                 .velocity = {random.uniform(5, 40), random.uniform(-20, 20)},
                 .angularVelocity = random.uniform(-10, 10)};
    const Material material{.restitution = random.uniform(0, 1)};
    if (random.integer(0, 1) == 0)
        shot.shapes = {circle(random.uniform(0.1, 0.4), material)};
    else
        shot.shapes = {box({random.uniform(0.1, 0.4), random.uniform(0.1, 0.4)}, material)};
    return shot;
}

/// Does the world do as was forecast?
void requireAsForecast(World& world, BodyId body, const Forecast& foreseen) {
    std::size_t hit = 0;
    for (std::size_t tick = 0; tick < foreseen.poses.size(); ++tick) {
        if (tick > 0) world.step(dt);
        const BodyView now = world.body(body);
        REQUIRE(sameBits(now.pose().position, foreseen.poses[tick].position));
        REQUIRE(sameBits(now.pose().rotation.sin, foreseen.poses[tick].rotation.sin));
        REQUIRE(sameBits(now.velocity(), foreseen.velocities[tick]));
        if (tick == 0) continue;
        for (const ContactBegin& begin : world.contactBegins()) {
            if (!(begin.shapeA.body == body) && !(begin.shapeB.body == body)) continue;
            REQUIRE(hit < foreseen.hits.size());
            REQUIRE(foreseen.hits[hit].tick == static_cast<int>(tick));
            REQUIRE(sameBits(foreseen.hits[hit].point, begin.point));
            REQUIRE(sameBits(foreseen.hits[hit].approachSpeed, begin.approachSpeed));
            ++hit;
        }
    }
    REQUIRE(hit == foreseen.hits.size());
}

}  // namespace

TEST_CASE("1,000 shots bounce as was forecast, to the last bit", "[record][rates][slow]") {
    Random random(51);
    std::size_t hits = 0;
    for (int i = 0; i < plumb::test::allCases(1000); ++i) {
        CAPTURE(i);
        World world = playground(random);
        const BodyDef shot = randomShot(random);
        const std::uint64_t before = stateHash(world);
        const Forecast foreseen = forecast(world, shot, 120, dt);
        REQUIRE(foreseen.poses.size() == 121);
        REQUIRE(stateHash(world) == before);
        hits += foreseen.hits.size();
        const BodyId body = world.add(shot);
        requireAsForecast(world, body, foreseen);
        requireAsForecast(world, body, forecast(world, body, 30, dt));  // also half way
    }
    CHECK(static_cast<int>(hits) > plumb::test::leastOf(1500));  // some fly over all within the two seconds
}

TEST_CASE("200 shots through wind, a pool and a star's pull fly as was forecast, to the last bit", "[record][rates]") {
    Random random(53);
    std::size_t hits = 0;
    for (int i = 0; i < plumb::test::allCases(200); ++i) {
        CAPTURE(i);
        World world = playground(random);
        addFields(world, random);
        const BodyDef shot = randomShot(random);
        const std::uint64_t before = stateHash(world);
        const Forecast foreseen = forecast(world, shot, 120, dt);
        REQUIRE(stateHash(world) == before);
        hits += foreseen.hits.size();
        const BodyId body = world.add(shot);
        requireAsForecast(world, body, foreseen);
        requireAsForecast(world, body, forecast(world, body, 30, dt));
    }
    CHECK(static_cast<int>(hits) > plumb::test::leastOf(100));  // some are blown over all, or swim
}

TEST_CASE("a hit's normal points away from what was hit, whichever of the two is A", "[record]") {
    World world;
    const BodyId low = world.add({.type = BodyType::Static, .shapes = {box({5, 0.5})}});
    const BodyId ball = world.add({.position = {0, 3}, .shapes = {circle(0.5)}});
    const Forecast ofBall = forecast(world, ball, 60, dt);
    REQUIRE(ofBall.hits.size() == 1);
    CHECK(ofBall.hits[0].other.body == low);
    CHECK(ofBall.hits[0].normal.y() == Approx(1));
    CHECK(ofBall.hits[0].approachSpeed == Approx(6.264).epsilon(0.02));  // sqrt(2 g 2 m)
    const Forecast ofFloor = forecast(world, low, 60, dt);
    REQUIRE(ofFloor.hits.size() == 1);
    CHECK(ofFloor.hits[0].normal.y() == Approx(-1));
}

TEST_CASE("a copy of a world goes on as the original, and is not touched by it", "[record][rates]") {
    Random random(52);
    for (int i = 0; i < 50; ++i) {
        World world = playground(random);
        World copy = world;
        const std::uint64_t now = stateHash(world);
        for (int tick = 0; tick < 60; ++tick) world.step(dt);
        CHECK(stateHash(copy) == now);
        for (int tick = 0; tick < 60; ++tick) copy.step(dt);
        CHECK(stateHash(copy) == stateHash(world));
        copy = world;
        world.step(dt);
        copy.step(dt);
        CHECK(stateHash(copy) == stateHash(world));
    }
}

TEST_CASE("a forecast of no ticks at a dt of nan is refused, as is what the world refuses, and negative ticks",
          "[record]") {
    World world, other;
    const BodyId body = world.add({.shapes = {circle(0.5)}});
    CHECK_THROWS_WITH(forecast(world, body, -1, dt), plumb::test::containsText("forecast: ticks: -1 is negative"));
    CHECK_THROWS_AS(forecast(other, body, 1, dt), std::invalid_argument);
    CHECK_THROWS_AS(forecast(world, body, 1, -dt), std::invalid_argument);
    CHECK_THROWS_AS(forecast(world, BodyDef{}, 1, dt), std::invalid_argument);
    CHECK(forecast(world, body, 0, dt).poses.size() == 1);
    // Also where no step is taken.
    CHECK_THROWS_WITH(forecast(world, body, 0, NAN), "forecast: dt: nan is not finite");
    CHECK_THROWS_WITH(forecast(world, BodyDef{}, 0, -dt), plumb::test::containsText("forecast: dt: -"));
}
