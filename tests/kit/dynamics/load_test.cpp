// SPDX-License-Identifier: MIT
// Heavy bodies on light ones: they stop, stand, and gain no energy.
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

ShapeDef ofDensity(ShapeDef shape, double density) {
    shape.material.density = density;
    return shape;
}

World onLevelGround(double gravity = 9.81) {
    World world({.gravity = {0, -gravity}});
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({60, 1})}});
    return world;
}

double storedEnergy(const World& world) {
    double sum = 0;
    for (const BodyId id : world.bodies()) {
        const auto body = world.body(id);
        const double w = body.angularVelocity();
        sum += 0.5 * body.mass() * body.velocity().squaredNorm() + 0.5 * body.inertia() * w * w -
               body.mass() * world.gravity().dot(body.position());
    }
    return sum;
}

/// A crate above a plank of 4 m that lies on the ground or on two posts.
struct CrateOverPlank {
    double half, density, aside, gravity;
    bool onPosts;
    static constexpr double fall = 0.5, thickness = 0.2;

    double plankTop() const { return (onPosts ? 1 : 0) + thickness; }
    World world() const {
        World world = onLevelGround(gravity);
        for (const double x : {-1.6, 1.6})
            if (onPosts) world.add({.type = BodyType::Static, .position = {x, 0.5}, .shapes = {box({0.1, 0.5})}});
        world.add({.position = {0, plankTop() - 0.5 * thickness}, .shapes = {box({2, 0.5 * thickness})}});
        for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
        return world;
    }
    BodyId drop(World& world) const {
        return world.add(
            {.position = {aside, plankTop() + half + fall}, .shapes = {ofDensity(box({half, half}), density)}});
    }
};

struct Rebound {
    double height = 0, rise = 0;  ///< as shares of the fall, and of its energy in one step
};

Rebound land(const CrateOverPlank& crate, double dt) {
    World world = crate.world();
    const BodyId id = crate.drop(world);
    const double fallen = world.body(id).mass() * crate.gravity * CrateOverPlank::fall;
    Rebound seen;
    bool landed = false;
    for (double t = 0, before = storedEnergy(world); t < 2; t += dt) {
        world.step(dt);
        const double now = storedEnergy(world), height = world.body(id).position().y() - crate.plankTop() - crate.half;
        landed = landed || height < 1e-3;
        if (landed) seen.height = std::max(seen.height, height / CrateOverPlank::fall);
        seen.rise = std::max(seen.rise, (now - before) / fallen);
        before = now;
    }
    return seen;
}

}  // namespace

TEST_CASE("a crate that falls on a loose plank stops there", "[dynamics][load]") {
    int cases = 0;
    for (const double dt : {1.0 / 60, 1.0 / 120})
        for (const bool onPosts : {false, true})
            for (const double half : {0.25, 0.5, 1.0})
                for (const double density : {10.0, 100.0})
                    for (const double aside : {0.0, 0.4, 1.0, 1.4})
                        for (const double gravity : {9.81, 20.0}) {
                            INFO("dt " << dt << ", posts " << onPosts << ", half " << half << ", density " << density
                                       << ", aside " << aside << ", gravity " << gravity);
                            const Rebound seen = land({half, density, aside, gravity, onPosts}, dt);
                            CHECK(seen.height <= 0.05);
                            CHECK(seen.rise <= 0.01);
                            ++cases;
                        }
    CHECK(cases == 192);
}

TEST_CASE("a large box on two small ones comes to rest level", "[dynamics][load]") {
    for (const double apart : {2.0, 5.0, 9.5})
        for (int i = 0; i <= 40; ++i) {
            const double height = 0.05 * i;
            World world = onLevelGround();
            for (const double x : {-apart, apart}) world.add({.position = {x, 0.5}, .shapes = {box({0.5, 0.5})}});
            const BodyId large = world.add({.position = {0, 11 + height}, .shapes = {box({10, 10})}});
            for (int step = 0; step < 600; ++step) world.step(1.0 / 60);
            INFO("small boxes at " << apart << " m, let down from " << height << " m");
            CHECK(std::fabs(world.body(large).angle()) < 0.002);
            CHECK(std::fabs(world.body(large).position().y() - 11) < 0.01);
        }
}

TEST_CASE("boxes of 20 to 1,000 times the mass do not sink into small ones", "[dynamics][load]") {
    for (const double density : {20.0, 100.0, 1000.0})
        for (const int count : {1, 2, 5}) {
            World world({.sleeping = false});
            world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({60, 1})}});
            for (int i = 0; i < count; ++i) world.add({.position = {0, 0.5 + i}, .shapes = {box({0.5, 0.5})}});
            const BodyId heavy =
                world.add({.position = {0, count + 0.5}, .shapes = {ofDensity(box({0.5, 0.5}), density)}});
            for (int step = 0; step < 600; ++step) world.step(1.0 / 60);
            INFO(density << " times the mass on " << count);
            CHECK(std::fabs(world.body(heavy).position().y() - count - 0.5) < 0.003);
            CHECK(std::fabs(world.body(heavy).angle()) < 0.002);
        }
}

TEST_CASE("heavy bodies that fall on heaps of light ones never rise above where they began", "[dynamics][load]") {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(allCases(300)); ++seed) {
        Random random(seed);
        World world = onLevelGround(random.uniform(4, 25));
        for (const double x : {-8.0, 8.0})
            world.add({.type = BodyType::Static, .position = {x, 4}, .shapes = {box({1, 6})}});
        const double size = random.uniform(0.1, 0.5), half = random.uniform(0.3, 2);
        const auto count = random.integer(2, 7);
        for (int i = 0; i < count; ++i) {
            const Vec2 place(-3 + 6 * (i + 0.5) / static_cast<double>(count), size / 2);
            world.add({.position = place, .shapes = {seed % 2 == 0 ? box({size / 2, size / 2}) : circle(size / 2)}});
        }
        const Vec2 place(random.uniform(-2, 2), size + 1.5 * half + random.uniform(0, 2));
        const double density = std::pow(10.0, random.uniform(0, 3));
        const BodyId heavy = world.add(
            {.position = place, .angle = random.uniform(-3, 3), .shapes = {ofDensity(box({half, half}), density)}});
        const double start = storedEnergy(world), scale = world.body(heavy).mass() * world.gravity().norm() * half;
        double most = start;
        for (int step = 0; step < 300; ++step) {
            world.step(1.0 / 60);
            most = std::max(most, storedEnergy(world));
        }
        INFO("seed " << seed << ", density " << density);
        CHECK(most - start < 0.01 * scale);
        CHECK(world.body(heavy).position().y() > 0.9 * half);
    }
}
