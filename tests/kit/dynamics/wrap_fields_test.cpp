// SPDX-License-Identifier: MIT
#include <cmath>

#include "cases.h"
#include "catch.h"
#include "kit/dynamics/edited.h"
#include "kit/dynamics/wrap_scenes.h"

namespace plumb::test {

namespace {

/// In a world of 20 m x 20 m without gravity.
World space() {
    return World({.gravity = {0, 0}, .wrap = {.width = 20.0, .height = 20.0}});
}

/// A pile in which fields act as well, all near its middle.
void addFields(WrapScene& scene, Random& random) {
    const Vec2 at(random.uniform(-2, 2), random.uniform(-2, 2));
    const Vec2 half(random.uniform(0.5, 3), random.uniform(0.5, 3));
    scene.world.addField({.law = Attractor{.center = scene.at(at), .strength = 20, .softening = 0.5, .range = 6}});
    scene.world.addField({.law = Drag{.linear = 0.5, .quadratic = 0.2, .wind = {2, 1}},
                          .region = Shape(boxPolygon(half, scene.at({at.y(), at.x()})))});
    scene.world.addField({.law = MutualGravity{.constant = 0.5, .softening = 0.3}});
    scene.world.addField(
        {.law = Magnet{.body = scene.world.bodies().back(), .pull = {.strength = 3, .softening = 0.4}}});
    const Vec2 pool = scene.at({0, -2.5});  // its surface is a place of its region, not a copy of it beyond the seam
    if (random.integer(0, 1) == 1)
        scene.world.addField({.law = Pool{.fluid = {.density = 2, .surface = pool + Vec2(0, 1)}, .drag = 1},
                              .region = Shape(boxPolygon({4, 1.5}, pool))});
}

}  // namespace

TEST_CASE("an attractor at 0.5 m draws what is at 19.5 m by the short way, and a magnet bears it",
          "[dynamics][wrap][tiles]") {
    World world = space();
    const BodyId body = world.add({.position = {19.5, 5}, .shapes = {circle(0.1)}});
    const FieldId field = world.addField({.law = Attractor{.center = {0.5, 5}, .strength = 2, .power = 1}});
    world.step(1e-3);
    // 2 N at 1 m.
    CHECK(std::fabs(world.body(body).velocity().x() * world.body(body).mass() / 1e-3 - 2) < 1e-3);
    world.remove(field);
    world.body(body).setVelocity({0, 0});
    const BodyId carrier = world.add({.position = {0.5, 5}, .shapes = {circle(0.1)}});
    world.addField({.law = Magnet{.body = carrier, .pull = {.strength = 2, .power = 1}}});
    world.step(1e-3);
    CHECK(world.body(body).velocity().x() > 0);
    CHECK(std::fabs(world.body(body).velocity().x() + world.body(carrier).velocity().x()) < 1e-12);
}

TEST_CASE("a region from 18 m to 2 m, given as from 18 m to 22 m or from -2 m to 2 m, holds what is in it",
          "[dynamics][wrap][tiles]") {
    for (const double middle : {20.0, 0.0, -20.0}) {
        World world = space();
        world.addField({.law = UniformGravity{{0, -2}}, .region = Shape(boxPolygon({2, 3}, {middle, 5}))});
        for (const double x : {17.0, 18.5, 19.9, 0.1, 1.5, 3.0}) {
            const BodyId body = world.add({.position = {x, 5}, .shapes = {circle(0.1)}});
            world.step(1e-3);
            const bool in = x > 18 || x < 2;
            CHECK((world.body(body).velocity().y() < 0) == in);
            world.remove(body);
        }
    }
}

TEST_CASE("two stars on either side of the seam fall together as they would elsewhere", "[dynamics][wrap][tiles]") {
    World seam = space(), open({.gravity = {0, 0}});
    std::vector<BodyId> here, there;
    for (const double x : {-1.0, 1.0}) {
        const BodyDef star{.position = {x, 0}, .velocity = {0, 0.6 * x}, .shapes = {circle(0.1)}};
        BodyDef wrapped = star;
        wrapped.position = seam.wrap().place(star.position);
        here.push_back(seam.add(wrapped));
        there.push_back(open.add(star));
    }
    for (World* world : {&seam, &open}) world->addField({.law = MutualGravity{.constant = 100, .softening = 0.1}});
    for (int i = 0; i < 240; ++i) {
        seam.step(dt);
        open.step(dt);
        for (std::size_t k = 0; k < 2; ++k)
            REQUIRE(seam.wrap().shortest(open.body(there[k]).position(), seam.body(here[k]).position()).norm() < 1e-9);
    }
}

TEST_CASE("an explosion at 19.8 m throws what is at 0.3 m to the right", "[dynamics][wrap][tiles]") {
    World world = space();
    const BodyId body = world.add({.position = {0.3, 5}, .shapes = {circle(0.1)}});
    world.explode({.center = {19.8, 5}, .radius = 1});
    // 1 N s/m on 0.2 m.
    CHECK(std::fabs(world.body(body).velocity().x() * world.body(body).mass() - 0.2) < 1e-9);
    CHECK(std::fabs(world.body(body).velocity().y()) < 1e-9);
}

TEST_CASE("500 piles in fields move across a seam as they do far from it", "[dynamics][wrap][tiles]") {
    Random random(32);
    const Wrap wrap{.width = 24.0, .height = 20.0};
    int astray = 0, astrayElsewhere = 0;
    for (int i = 0; i < cases(500); ++i) {
        const std::uint64_t seed = random.bits();
        const auto divergence = [&](const Vec2& middle) {
            Random own(seed), same(seed);
            WrapScene far(seed, wrap, {12, 10}), other(seed, wrap, middle);
            addFields(far, own);
            addFields(other, same);
            double farthest = 0;
            const std::vector<BodyId> inFar = far.world.bodies(), inOther = other.world.bodies();
            for (int step = 0; step < 30; ++step) {
                far.step();
                other.step();
                for (std::size_t k = 0; k < inFar.size(); ++k) {
                    const Vec2 a = far.world.body(inFar[k]).position(), b = other.world.body(inOther[k]).position();
                    farthest = std::max(farthest, (far.local(a) - other.local(b)).norm());
                }
            }
            return farthest;
        };
        // A thousand times what the solver's floats know of a metre: more where impacts meet, wherever that is.
        const Vec2 seam(random.uniform(-4, 4), random.uniform(-4, 4));
        const Vec2 elsewhere(random.uniform(8, 16), random.uniform(7, 13));
        astray += divergence(seam) < 6e-5 ? 0 : 1;
        astrayElsewhere += divergence(elsewhere) < 6e-5 ? 0 : 1;
    }
    // Three deviations of what is counted elsewhere.
    CHECK(astray <= astrayElsewhere + 2 + 3 * std::sqrt(astrayElsewhere + 1.0));
    CHECK(astray <= 0.1 * cases(500));
}

TEST_CASE("a world that wraps is copied, foretold and kept account of as any", "[dynamics][wrap][tiles]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        WrapScene scene(seed, {.width = 24.0, .height = 20.0}, {0, 0});
        for (int i = 0; i < 20; ++i) scene.step();
        World copy = scene.world;
        const BodyId body = copy.bodies().back();
        const Forecast foretold = forecast(scene.world, body, 30, dt);
        for (std::size_t i = 1; i <= 30; ++i) {
            scene.step();
            copy.step(dt);
            CHECK(scene.world.body(body).position() == foretold.poses[i].position);
        }
        CHECK(stateHash(copy) == stateHash(scene.world));
    }
    World world({.wrap = {.width = 10.0, .height = 10.0}, .ledger = true});
    Random random(33);
    for (int i = 0; i < 30; ++i)
        world.add({.position = {random.uniform(0, 10), random.uniform(0, 10)},
                   .velocity = {random.uniform(-3, 3), random.uniform(-3, 3)},
                   .shapes = {circle(0.2, {.restitution = 0.5})}});
    steps(world, 300);
    const EnergyLedger energy = world.ledger().energy;
    const double most = std::fabs(energy.kinetic) + std::fabs(energy.gravitational) + std::fabs(energy.edits);
    CHECK(std::fabs(energy.stored() - energy.gained()) < 1e-9 * most);
    CHECK(energy.impacts < 0);
    // All fall alike, and what they lose is what impacts and friction take.
    CHECK(std::fabs(energy.solver) < 1e-3 * most);
}

}  // namespace plumb::test
