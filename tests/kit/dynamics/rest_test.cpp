// SPDX-License-Identifier: MIT
// What rests, rests: columns, steps of changing length, bodies that were put into each other.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

World onFloor(const WorldDef& def = {}) {
    World world(def);
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({40, 1})}});
    return world;
}

/// Seed 0: equal boxes of 1 m, exactly above each other. Other seeds: their sizes differ, and they stand up to 2 cm
/// off.
std::vector<BodyId> columnOf(World& world, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<BodyId> column;
    double top = 0;
    for (int i = 0; i < count; ++i) {
        const Vec2 half = seed == 0 ? Vec2(0.5, 0.5) : Vec2(random.uniform(0.4, 0.6), random.uniform(0.4, 0.6));
        const double aside = seed == 0 ? 0 : random.uniform(-0.02, 0.02);
        column.push_back(world.add({.position = {aside, top + half.y()}, .shapes = {plumb::box(half)}}));
        top += 2 * half.y();
    }
    return column;
}

double farthestAside(const World& world, const std::vector<BodyId>& bodies) {
    double aside = 0;
    for (const BodyId body : bodies) aside = std::max(aside, std::fabs(world.body(body).position().x()));
    return aside;
}

struct Steps {
    std::string name;
    std::function<double(int, Random&)> length;  ///< of each step [s]
};

const std::vector<Steps>& stepPatterns() {
    static const std::vector<Steps> patterns{
        {"every third 1 ms", [](int i, Random&) { return i % 3 == 0 ? 1e-3 : 1.0 / 60; }},
        {"every eleventh 0.1 s", [](int i, Random&) { return i % 11 == 10 ? 0.1 : 1.0 / 60; }},
        {"30 and 120 Hz in turns", [](int i, Random&) { return i % 2 == 0 ? 1.0 / 30 : 1.0 / 120; }},
        {"60 and 240 Hz in turns", [](int i, Random&) { return i % 2 == 0 ? 1.0 / 60 : 1.0 / 240; }},
        {"30 to 240 Hz at random", [](int, Random& random) { return 1 / random.uniform(30, 240); }},
        {"1 to 33 ms at random", [](int, Random& random) { return 1e-3 * std::pow(33.0, random.uniform(0, 1)); }},
        {"once a second 1/4 s", [](int i, Random&) { return i % 60 == 59 ? 0.25 : 1.0 / 60; }},
        {"144 Hz, some 50 ms", [](int i, Random&) { return i % 17 == 16 ? 0.05 : 1.0 / 144; }},
        {"10 to 110 Hz, slowly", [](int i, Random&) { return 1 / (60 + 50 * std::sin(0.05 * i)); }},
        {"every second 1 us", [](int i, Random&) { return i % 2 == 0 ? 1e-6 : 1.0 / 60; }},
    };
    return patterns;
}

/// A pyramid whose boxes of 1 m are nearer by a part than they should be.
struct Pyramid {
    std::vector<BodyId> boxes;
    std::vector<int> rows;

    Pyramid(World& world, int base, double part) {
        const double pitch = 1 - part;
        for (int row = 0; row < base; ++row)
            for (int i = 0; i + row < base; ++i) {
                const Vec2 place(pitch * (i + 0.5 * row), 0.5 + pitch * row);
                boxes.push_back(world.add({.position = place, .shapes = {plumb::box({0.5, 0.5})}}));
                rows.push_back(row);
            }
    }
    double fastest(const World& world) const {
        double speed = 0;
        for (const BodyId box : boxes) speed = std::max(speed, world.body(box).velocity().norm());
        return speed;
    }
    double farthestFromRow(const World& world) const {
        double far = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            far = std::max(far, std::fabs(world.body(boxes[i]).position().y() - rows[i] - 0.5));
        return far;
    }
};

}  // namespace

TEST_CASE("a column of forty boxes that are kept awake stands for a minute", "[dynamics][rest]") {
    for (int seed = 0; seed < allCases(4); ++seed) {
        World world = onFloor({.gravity = {0, -10}, .sleeping = false});
        const std::vector<BodyId> column = columnOf(world, 40, static_cast<std::uint64_t>(seed));
        for (int tick = 0; tick < 3600; ++tick) world.step(1.0 / 60);
        INFO("seed " << seed);
        CHECK(farthestAside(world, column) < 0.5);
    }
}

TEST_CASE("a leaning tower falls if a part of it is beyond its edge, and only then", "[dynamics][rest]") {
    for (const double aside : {0.1, 0.16, 0.19, 0.21, 0.25}) {  // at 0.2, the upper four are balanced on an edge
        World world = onFloor({.sleeping = false});
        for (int i = 0; i < 5; ++i)
            world.add({.position = {aside * i, 0.5 + i}, .shapes = {plumb::box({0.5, 0.5}, {.friction = 1})}});
        const BodyId top = world.bodies().back();
        for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
        INFO("each is " << aside << " m beyond the one below");
        CHECK((world.body(top).position().y() < 4) == (aside > 0.2));
    }
}

TEST_CASE("towers stand for a minute while the step's length changes", "[dynamics][rest]") {
    for (const Steps& steps : stepPatterns())
        for (const int count : {6, 12}) {
            Random random(7);
            World world = onFloor({.sleeping = false});
            const std::vector<BodyId> tower = columnOf(world, count, 0);
            double time = 0;
            for (int tick = 0; time < 60; ++tick) {
                const double dt = steps.length(tick, random);
                world.step(dt);
                time += dt;
            }
            INFO(steps.name << ", " << count << " boxes");
            CHECK(farthestAside(world, tower) < 0.5);
        }
}

TEST_CASE("a pyramid that was put into itself comes apart at rest, row by row", "[dynamics][rest]") {
    // Larger ones that were put into each other by half are thrown apart: 5 of 100 pyramids of 3 to 12 rows.
    for (const int base : {4, 7})
        for (const double part : {0.1, 0.25, 0.4, 0.5}) {
            World world = onFloor();
            const Pyramid pyramid(world, base, part);
            double fastest = 0;
            for (int tick = 0; tick < 600; ++tick) {
                world.step(1.0 / 60);
                fastest = std::max(fastest, pyramid.fastest(world));
            }
            INFO("base " << base << ", " << 100 * part << " %");
            CHECK(fastest < 1);
            CHECK(pyramid.farthestFromRow(world) < 0.05);
        }
}

TEST_CASE("elastic discs under gravity keep their energy and their box, however dense and at 30 Hz",
          "[dynamics][rest]") {
    for (const double filled : {0.2, 0.6})
        for (const double hz : {30.0, 60.0}) {
            constexpr int count = 36;
            constexpr double radius = 0.3;
            const double side = std::sqrt(count * 3.14159265358979 * radius * radius / filled);
            const Material elastic{.friction = 0, .restitution = 1};
            World world({.gravity = {0, -9.81}, .sleeping = false});
            for (const Vec2& wall : {Vec2(0.5, -0.5), Vec2(0.5, 1.5), Vec2(-0.5, 0.5), Vec2(1.5, 0.5)})
                world.add({.type = BodyType::Static,
                           .position = wall * side,
                           .shapes = {plumb::box({0.5 * side, 0.5 * side}, elastic)}});
            const double pitch = (side - 2 * radius - 2e-3) / 5;
            Random random(1);
            std::vector<BodyId> discs;
            for (int i = 0; i < count; ++i) {
                const double angle = random.uniform(0, 6.28);
                discs.push_back(
                    world.add({.position = {radius + 1e-3 + pitch * (i % 6), radius + 1e-3 + pitch * (i / 6)},
                               .velocity = {3 * std::cos(angle), 3 * std::sin(angle)},
                               .shapes = {circle(radius, elastic)}}));
            }
            const auto energy = [&] {
                double sum = 0;
                for (const BodyId disc : discs)
                    sum += 0.5 * world.body(disc).velocity().squaredNorm() + 9.81 * world.body(disc).position().y();
                return sum;
            };
            const double start = energy();
            double deepest = 0;
            for (int tick = 0; tick < 30 * hz; ++tick) {
                world.step(1 / hz);
                for (const BodyId disc : discs) deepest = std::max(deepest, radius - world.body(disc).position().y());
            }
            INFO(filled << " filled, " << hz << " Hz");
            CHECK(std::fabs(energy() / start - 1) < 1e-9);
            CHECK(deepest < 1e-6);
        }
}
