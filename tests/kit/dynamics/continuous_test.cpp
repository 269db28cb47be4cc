// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// From a to b, as many small as large ones.
double spread(Random& random, double a, double b) {
    return a * std::exp(random.uniform(0, std::log(b / a)));
}

/// What flies, and how far it reaches from its centre.
struct Bullet {
    ShapeDef shape;
    double extent = 0;
};

Bullet randomBullet(Random& random, const Material& material) {
    const double radius = spread(random, 1e-3, 0.5), size = std::max(radius, 4e-3);  // the thinnest is 2 mm thick
    const double thin = spread(random, 5e-3, 0.05);
    const double wide = size * random.uniform(0.3, 1);
    const std::vector<Vec2> triangle{{-size, -0.4 * size}, {0.8 * size, -0.5 * size}, {0.2 * size, 0.9 * size}};
    switch (random.integer(0, 6)) {
        case 0: return {circle(radius, material), radius};
        case 1: return {capsule({-size, 0}, {size, 0}, wide, material), size + wide};
        case 2: return {plumb::box({size, wide}, material), size + wide};
        case 3: return {plumb::box({5, thin}, material), 5.1};
        case 4: return {polygon(triangle, material), 2 * size};
        case 5: return {roundedPolygon(triangle, 0.2 * size, material), 2 * size};
        default: return {roundedBox({size, wide}, 0.3 * wide, material), size + 2 * wide};
    }
}

constexpr double wallHalfLength = 600;

/// A wall along x of its frame, through its origin; half a centimetre to either side where it has a thickness.
ShapeDef randomWall(Random& random, const Material& material) {
    const Vec2 left(-wallHalfLength, 0), right(wallHalfLength, 0);
    switch (random.integer(0, 2)) {
        case 0: return plumb::box({wallHalfLength, 0.005}, material);
        case 1: return segment(left, right, material);
        default: {
            std::vector<Vec2> points;
            for (int i = 0; i <= 24; ++i) points.push_back(left + (right - left) * (i / 24.0));
            return chain(points, material);
        }
    }
}

struct Range {
    std::optional<World> world;
    BodyId wall;
    std::vector<BodyId> bullets;
    double dt = 1.0 / 60;
    int steps = 0;
};

/// How a bullet that starts away from the wall is to meet it.
struct Aim {
    double speed = 0, spin = 0, distance = 0;
};

Aim randomAim(Random& random) {
    return {spread(random, 1, 1000), random.uniform(-1, 1) * spread(random, 1, 1000), spread(random, 0.01, 30)};
}

BodyDef flying(const Bullet& bullet, const Transform& wall, const Aim& aim, Random& random) {
    const double slant = random.uniform(-1, 1);  // [rad] off the normal
    const Vec2 start(random.uniform(-5, 5), bullet.extent + 0.005 + aim.distance);
    return {.position = wall * start,
            .angle = random.uniform(-pi, pi),
            .velocity = wall.rotation * Vec2(aim.speed * std::sin(slant), -aim.speed * std::cos(slant)),
            .angularVelocity = aim.spin,
            .shapes = {bullet.shape}};
}

double randomStep(Random& random) {
    const std::array<double, 10> rates{60, 60, 60, 60, 60, 60, 30, 30, 120, 120};
    return 1 / rates[static_cast<std::size_t>(random.integer(0, 9))];
}

Range randomRange(Random& random) {
    Range range;
    range.dt = randomStep(random);
    const bool gravity = random.integer(0, 1) == 1;
    range.world.emplace(WorldDef{.gravity = {0, gravity ? -9.81 : 0}});
    const bool bouncy = random.integer(0, 1) == 1;
    const Material material{.friction = random.uniform(0, 1), .restitution = bouncy ? random.uniform(0, 1) : 0};
    const Transform pose{{random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)},
                         Rot::fromAngle(random.uniform(-pi, pi))};
    BodyDef wall{.type = BodyType::Static,
                 .position = pose.position,
                 .angle = pose.rotation.angle(),
                 .shapes = {randomWall(random, material)}};
    double toward = 0;
    if (random.integer(0, 3) == 0) {  // it comes or goes; what goes is to be caught up with
        wall.type = BodyType::Kinematic;
        toward = random.uniform(-50, 100);
        wall.velocity = pose.rotation * Vec2(random.uniform(-20, 20), toward);
    }
    range.wall = range.world->add(wall);
    const Bullet bullet = randomBullet(random, material);
    const Aim aim = randomAim(random);
    BodyDef first = flying(bullet, pose, aim, random);
    const int pusher = random.integer(0, 3);
    if (pusher == 0) first.velocity *= 0.01;
    if (toward != 0 && random.integer(0, 2) == 0) first.velocity.setZero();
    range.bullets.push_back(range.world->add(first));
    if (pusher == 0) {  // another comes from behind, straight at the first
        const Bullet second = randomBullet(random, material);
        BodyDef behind = first;
        const Vec2 back = pose.rotation * Vec2(0, bullet.extent + second.extent + 0.01);
        behind.position += back;
        behind.velocity = -aim.speed * back.normalized();
        behind.shapes = {second.shape};
        range.bullets.push_back(range.world->add(behind));
    }
    const double closing = std::max(aim.speed * 0.5, 1.0) + std::max(toward, 0.0);
    range.steps = 5 + std::min(60, static_cast<int>((aim.distance + bullet.extent) / (closing * range.dt)));
    return range;
}

/// The lowest that a bullet's centre comes over the wall's middle, as long as the wall reaches so far [m].
double lowest(Range& range) {
    double least = 1;
    for (int i = 0; i < range.steps; ++i) {
        range.world->step(range.dt);
        const Transform wall = range.world->body(range.wall).pose().inverse();
        for (const BodyId bullet : range.bullets) {
            const Vec2 at = wall * range.world->body(bullet).centerOfMass();
            if (std::fabs(at.x()) < wallHalfLength - 20) least = std::min(least, at.y());
        }
    }
    return least;
}

}  // namespace

TEST_CASE("of 100,000 shots at walls of 1 cm and of no thickness, up to 1,000 m/s, none goes through",
          "[dynamics][bullets]") {
    int through = 0;
    for (int seed = 0; seed < cases(100000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Range range = randomRange(random);
        if (lowest(range) > 0) continue;
        ++through;
        WARN("shot " << seed << " went through");
    }
    CHECK(through == 0);
}

TEST_CASE("a disc of 1 mm at 1,000 m/s stops at a chain at e = 0, and comes back at 500 m/s at e = 0.5",
          "[dynamics][bullets]") {
    for (const double e : {0.0, 0.5}) {
        World world({.gravity = {0, 0}});
        const Material material{.friction = 0, .restitution = e};
        world.add({.type = BodyType::Static, .shapes = {chain({{20, 0}, {0, 0}, {-20, 0}}, material)}});
        const BodyId disc = world.add({.position = {1, 7}, .velocity = {0, -1000}, .shapes = {circle(1e-3, material)}});
        for (int tick = 0; tick < 3; ++tick) world.step(1.0 / 60);
        CHECK(std::fabs(world.body(disc).velocity().y() - 1000 * e) < 1e-3);
        if (e == 0) CHECK(std::fabs(world.body(disc).position().y() - 1e-3) < 1e-3);
        // hit after 6.999 ms
        if (e > 0) CHECK(std::fabs(world.body(disc).position().y() - (1e-3 + 500 * (0.05 - 0.006999))) < 1e-3);
    }
}

TEST_CASE("a rod of 10 m at 1,000 rad/s that flies at a wall of 1 cm at 100 m/s is stopped by it",
          "[dynamics][bullets]") {
    World world({.gravity = {0, 0}});
    world.add({.type = BodyType::Static, .shapes = {plumb::box({100, 0.005})}});
    const BodyId rod = world.add(
        {.position = {0, 6}, .velocity = {0, -100}, .angularVelocity = 1000, .shapes = {plumb::box({5, 0.005})}});
    for (int tick = 0; tick < 60; ++tick) {
        world.step(1.0 / 60);
        REQUIRE(world.body(rod).position().y() > 0);
    }
}

TEST_CASE("a kinematic wall at 200 m/s sweeps a resting disc along and leaves none behind", "[dynamics][bullets]") {
    World world({.gravity = {0, 0}});
    const BodyId wall = world.add(
        {.type = BodyType::Kinematic, .position = {-2, 0}, .velocity = {200, 0}, .shapes = {segment({0, -5}, {0, 5})}});
    std::vector<BodyId> discs;
    for (int i = 0; i < 5; ++i)
        discs.push_back(world.add({.position = {1.3 * i, 0.5 * i - 1}, .shapes = {circle(0.02 + 0.03 * i)}}));
    for (int tick = 0; tick < 30; ++tick) {
        world.step(1.0 / 60);
        for (const BodyId disc : discs) CHECK(world.body(disc).position().x() > world.body(wall).position().x());
    }
}

TEST_CASE("what flies past a wall's end at 500 m/s is not stopped", "[dynamics][bullets]") {
    World world({.gravity = {0, 0}});
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {0, 0})}});
    const BodyId box = world.add(
        {.position = {0.2, 30}, .velocity = {0, -500}, .angularVelocity = 40, .shapes = {plumb::box({0.1, 0.1})}});
    for (int tick = 0; tick < 12; ++tick) world.step(1.0 / 60);
    CHECK(world.body(box).velocity() == Vec2(0, -500));
    CHECK(std::fabs(world.body(box).position().y() + 70) < 1e-9);
}
