// SPDX-License-Identifier: MIT
// Does a crowd that is far away change what a small group does?
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// Bodies in a square basin, on a lattice, that start at the same speed in all directions.
struct FarCrowd {
    double halfWidth = 5;  ///< of the basin [m]
    int count = 40;
    double radius = 0.3;  ///< [m]
    double speed = 5;     ///< [m/s]
    Material material = {};
    int kinds = 3;  ///< 1: discs; 2: also boxes; 3: also capsules
};

std::vector<BodyId> addCrowd(World& world, const FarCrowd& crowd, const Vec2& at) {
    const double w = crowd.halfWidth, r = crowd.radius;
    world.add({.type = BodyType::Static,
               .position = at,
               .shapes = {loop({{-w, -w}, {w, -w}, {w, w}, {-w, w}}, crowd.material)}});
    const int columns = static_cast<int>(std::ceil(std::sqrt(crowd.count)));
    Random random(4);
    std::vector<BodyId> bodies;
    for (int i = 0; i < crowd.count; ++i) {
        ShapeDef shape = circle(r, crowd.material);
        if (i % crowd.kinds == 1) shape = box({r, 0.8 * r}, crowd.material);
        if (i % crowd.kinds == 2) shape = capsule({-0.4 * r, 0}, {0.4 * r, 0}, 0.5 * r, crowd.material);
        const Vec2 cell(i % columns + 0.5, i / columns + 0.5);
        const double way = random.uniform(0, 2 * std::numbers::pi);
        bodies.push_back(world.add({.position = at - Vec2(w, w) + cell * (2 * w / columns),
                                    .velocity = crowd.speed * Vec2(std::cos(way), std::sin(way)),
                                    .angularVelocity = random.uniform(-3, 3),
                                    .shapes = {shape}}));
    }
    return bodies;
}

bool isSameMotion(const World& one, BodyId a, const World& other, BodyId b) {
    const auto p = one.body(a), q = other.body(b);
    return p.position() == q.position() && p.velocity() == q.velocity() && p.angle() == q.angle() &&
           p.angularVelocity() == q.angularVelocity() && p.awake() == q.awake();
}

/// The first step after which a group moves differently because of a crowd 1 km away; -1 if there is none.
int firstChange(const FarCrowd& group, const FarCrowd& far, const Vec2& gravity, int steps, bool farFirst) {
    World alone({.gravity = gravity}), both({.gravity = gravity});
    const Vec2 there(1000, 3);
    const std::vector<BodyId> wanted = addCrowd(alone, group, {0, 0});
    if (farFirst) addCrowd(both, far, there);
    const std::vector<BodyId> found = addCrowd(both, group, {0, 0});
    if (!farFirst) addCrowd(both, far, there);
    for (int step = 0; step < steps; ++step) {
        alone.step(dt);
        both.step(dt);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (!isSameMotion(alone, wanted[i], both, found[i])) return step;
    }
    return -1;
}

const Vec2 weightlessHere(0, 0), pullHere(0, -g);
const Material elasticHere{.friction = 0, .restitution = 1};
const FarCrowd pileOf60{.count = 60, .radius = 0.4, .speed = 1, .material = {.restitution = 0}};
const FarCrowd bouncingCrowd{.material = {.friction = 0.3, .restitution = 0.7}};
/// At 1000 m/s it needs more predictions than it may use.
const FarCrowd denseGas{.halfWidth = 1, .count = 49, .radius = 0.1, .speed = 1000, .material = elasticHere, .kinds = 1};
const FarCrowd thinGas{.halfWidth = 2, .count = 200, .radius = 0.09, .speed = 5, .material = elasticHere, .kinds = 1};

}  // namespace

TEST_CASE("a crowd that bounces 1 km away does not change a bit of what 40 bouncing discs, boxes and capsules do",
          "[dynamics][determinism]") {
    for (const bool farFirst : {false, true}) {
        CHECK(firstChange(bouncingCrowd, bouncingCrowd, pullHere, 300, farFirst) == -1);
        CHECK(firstChange(bouncingCrowd, thinGas, pullHere, 150, farFirst) == -1);
    }
}

TEST_CASE("a crowd that bounces 1 km away does not change a bit of how 60 bodies pile up", "[dynamics][determinism]") {
    for (const bool farFirst : {false, true})
        CHECK(firstChange(pileOf60, bouncingCrowd, pullHere, 200, farFirst) == -1);
}

TEST_CASE("a gas that spends its predictions 1 km away leaves those of a small elastic gas",
          "[dynamics][determinism]") {
    const FarCrowd small{
        .halfWidth = 0.5, .count = 16, .radius = 0.08, .speed = 5, .material = elasticHere, .kinds = 1};
    for (const bool farFirst : {false, true}) CHECK(firstChange(small, denseGas, weightlessHere, 30, farFirst) == -1);
}
