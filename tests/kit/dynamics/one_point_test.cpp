// SPDX-License-Identifier: MIT
// Do far too many bodies in one place get on?
#include <algorithm>
#include <cstdint>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double size = 0.25;

std::vector<ShapeDef> pointShapes() {
    return {circle(size), box({size, size}), capsule({-0.2, 0}, {0.2, 0}, 0.1),
            polygon({{0.3, 0}, {0.1, 0.28}, {-0.24, 0.18}, {-0.24, -0.18}, {0.1, -0.28}})};
}

std::vector<BodyId> addAtOnePoint(World& world, int count, const ShapeDef& shape) {
    std::vector<BodyId> bodies;
    Random random(1);  // exactly at one point, discs would line up
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-1e-3, 1e-3);
        bodies.push_back(world.add({.position = {x, random.uniform(-1e-3, 1e-3)}, .shapes = {shape}}));
    }
    return bodies;
}

double deepestOverlap(const World& world, const std::vector<BodyId>& bodies) {
    double deepest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 apart = world.body(bodies[i]).position() - world.body(bodies[j]).position();
            if (apart.norm() > 4 * size) continue;
            deepest = std::max(deepest, -world.distance({bodies[i], 0}, {bodies[j], 0}).separation);
        }
    return deepest;
}

/// Do the contacts of a body name another one twice?
bool hasOneTwice(const World& world, BodyId body) {
    std::vector<std::uint32_t> others;
    for (const Contact& contact : world.body(body).contacts())
        others.push_back((contact.shapeA.body == body ? contact.shapeB : contact.shapeA).body.index);
    std::sort(others.begin(), others.end());
    return std::adjacent_find(others.begin(), others.end()) != others.end();
}

}  // namespace

TEST_CASE("four hundred bodies that are made at one point get few contacts, and come apart", "[dynamics][crowd]") {
    for (const bool wraps : {false, true}) {
        for (const ShapeDef& shape : pointShapes()) {
            WorldDef def{.gravity = {0, 0}, .sleeping = false};
            if (wraps) def.wrap = {.width = 50, .height = 50};
            World world(def);
            const std::vector<BodyId> bodies = addAtOnePoint(world, 400, shape);
            std::size_t most = 0;
            for (int step = 0; step < 900; ++step) {
                world.step(dt);
                most = std::max(most, step < 60 ? world.counts().contacts : 0);
            }
            INFO("shape " << shape.shape.index() << (wraps ? ", wraps" : ""));
            CHECK(most < 20'000);  // of 79,800
            CHECK(deepestOverlap(world, bodies) < 0.02);
        }
    }
}

TEST_CASE("bodies of a crowd can be removed, added and hidden while it spreads, and no two get two contacts",
          "[dynamics][crowd]") {
    World world({.gravity = {0, 0}, .sleeping = false});
    std::vector<BodyId> bodies = addAtOnePoint(world, 300, circle(size));
    int twice = 0;
    for (std::size_t step = 0; step < 900; ++step) {
        world.step(dt);
        if (step > 200) continue;
        for (const BodyId body : bodies) twice += hasOneTwice(world, body) ? 1 : 0;
        world.body(bodies[(step + 50) % bodies.size()]).setEnabled(false);
        world.body(bodies[(step + 50) % bodies.size()]).setEnabled(true);
        if (step % 7 != 0) continue;
        world.remove(bodies[step]);
        bodies[step] = world.add({.shapes = {box({size, size})}});
    }
    CHECK(twice == 0);
    CHECK(deepestOverlap(world, bodies) < 0.02);
}
