// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include <plumb/shapes/chain.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

ShapeDef asSensor(ShapeDef shape) {
    shape.sensor = true;
    return shape;
}

struct Visits {
    std::size_t begins = 0, ends = 0;
};

Visits visitsOf(World& world, int ticks) {
    Visits visits;
    for (int tick = 0; tick < ticks; ++tick) {
        world.step(dt);
        visits.begins += world.sensorBegins().size();
        visits.ends += world.sensorEnds().size();
    }
    return visits;
}

}  // namespace

TEST_CASE("a ball that falls through a gate begins and ends with it when it overlaps and no more, and falls as without",
          "[dynamics][sensor]") {
    World world, empty;
    const BodyDef ball{.position = {0, 5}, .shapes = {circle(0.25)}};
    const BodyId falling = world.add(ball);
    const BodyId gate = world.add({.type = BodyType::Static, .shapes = {asSensor(plumb::box({1, 0.5}))}});
    empty.add(ball);
    bool inside = false;
    int changes = 0;
    for (int tick = 0; tick < 120; ++tick) {
        world.step(dt);
        empty.step(dt);
        CHECK(world.body(falling).position() == empty.body(empty.bodies()[0]).position());
        CHECK(world.contactBegins().empty());
        const bool overlaps = std::fabs(world.body(falling).position().y()) <= 0.75;
        REQUIRE(world.sensorBegins().size() == (overlaps && !inside ? 1 : 0));
        REQUIRE(world.sensorEnds().size() == (!overlaps && inside ? 1 : 0));
        if (overlaps == inside) continue;
        ++changes;
        inside = overlaps;
        if (!inside) continue;
        CHECK(world.sensorBegins()[0].sensor == ShapeId{gate, 0});
        CHECK(world.sensorBegins()[0].visitor == ShapeId{falling, 0});
    }
    CHECK(changes == 2);
}

TEST_CASE("every kind of body sees every kind pass but static what is static, and no sensor a sensor",
          "[dynamics][sensor]") {
    for (const BodyType own : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
        for (const BodyType other : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
            for (const bool both : {false, true}) {
                World world = weightless();
                world.add({.type = own, .shapes = {asSensor(circle(1))}});
                world.add({.type = other,
                           .position = {0.5, 0},
                           .shapes = {both ? asSensor(plumb::box({1, 1})) : plumb::box({1, 1})}});
                const bool sees = !both && (own != BodyType::Static || other != BodyType::Static);
                CHECK(visitsOf(world, 3).begins == (sees ? 1 : 0));
            }
        }
    }
}

TEST_CASE("a box that sleeps in a sensor stays in it, and is not woken by one that comes", "[dynamics][sensor]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {segment({-5, 0}, {5, 0})}});
    const BodyId box = world.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    world.add({.type = BodyType::Static, .shapes = {asSensor(circle(1))}});
    Visits visits = visitsOf(world, 120);
    CHECK_FALSE(world.body(box).awake());
    CHECK(visits.begins == 1);
    CHECK(visits.ends == 0);
    world.add({.type = BodyType::Static, .shapes = {asSensor(plumb::box({2, 2}))}});
    const BodyId rover = world.add(
        {.type = BodyType::Kinematic, .position = {-3, 0}, .velocity = {1, 0}, .shapes = {asSensor(circle(1))}});
    visits = visitsOf(world, 360);
    CHECK_FALSE(world.body(box).awake());
    CHECK(visits.begins == 2 + 1);  // and the rover sees the floor
    CHECK(visits.ends == 1);
    CHECK(world.body(rover).position().x() > 2.9);
}

TEST_CASE("a visit ends when either is removed, disabled or set elsewhere", "[dynamics][sensor]") {
    for (int way = 0; way < 6; ++way) {
        World world = weightless();
        const BodyId gate = world.add({.type = BodyType::Static, .shapes = {asSensor(circle(1))}});
        const BodyId ball = world.add({.shapes = {circle(0.5)}});
        CHECK(visitsOf(world, 2).begins == 1);
        const BodyId changed = way % 2 == 0 ? gate : ball;
        if (way / 2 == 0) world.remove(changed);
        if (way / 2 == 1) world.body(changed).setEnabled(false);
        if (way / 2 == 2) world.body(changed).setPose({10, 0}, 0);
        world.step(dt);
        REQUIRE(world.sensorEnds().size() == 1);
        CHECK(world.sensorEnds()[0].sensor.body == gate);
        CHECK(world.sensorEnds()[0].visitor.body == ball);
        CHECK(visitsOf(world, 3).ends == 0);
    }
}

TEST_CASE("a ball set from one place in a sensor to another stays in it without an event", "[dynamics][sensor]") {
    World world = weightless();
    world.add({.type = BodyType::Static, .shapes = {asSensor(circle(2))}});
    const BodyId ball = world.add({.shapes = {circle(0.5)}});
    CHECK(visitsOf(world, 2).begins == 1);
    world.body(ball).setPose({1, 0}, 0);
    const Visits visits = visitsOf(world, 3);
    CHECK(visits.begins + visits.ends == 0);
}

TEST_CASE("a bullet at 500 m/s through a sensor 1 cm thick begins and ends in one step, past it, it does not",
          "[dynamics][sensor]") {
    for (const double y : {0.0, 1.2}) {
        World world = weightless();
        world.add({.type = BodyType::Static, .shapes = {asSensor(plumb::box({0.005, 1}))}});
        world.add({.position = {-12, y}, .velocity = {500, 0}, .shapes = {circle(0.05)}});
        const Visits visits = visitsOf(world, 10);
        CHECK(visits.begins == (y == 0 ? 1 : 0));
        CHECK(visits.ends == (y == 0 ? 1 : 0));
    }
}

TEST_CASE("a bullet that a wall sends back through a sensor before it is seen to pass once a step",
          "[dynamics][sensor]") {
    World world = weightless();
    world.add({.type = BodyType::Static, .shapes = {segment({0, -5}, {0, 5}, {.restitution = 1})}});
    world.add({.type = BodyType::Static, .position = {-1, 0}, .shapes = {asSensor(plumb::box({0.005, 1}))}});
    world.add({.position = {-4, 0}, .velocity = {480, 0}, .shapes = {circle(0.05)}});
    world.step(dt);  // to the wall at 3.95 m and 4.05 m back
    CHECK(world.sensorBegins().size() == 1);
    CHECK(world.sensorEnds().size() == 1);
}

TEST_CASE("a chain of a hundred pieces that moves across a sensor is one visitor, in once and out once",
          "[dynamics][sensor]") {
    World world = weightless();
    world.add({.type = BodyType::Static, .shapes = {asSensor(circle(1))}});
    std::vector<Vec2> points;
    for (int i = 0; i <= 100; ++i) points.emplace_back(-5 + 0.1 * i, 0.1 * std::sin(i));
    world.add({.type = BodyType::Kinematic, .position = {-10, 0}, .velocity = {10, 0}, .shapes = {chain(points)}});
    const Visits visits = visitsOf(world, 120);
    CHECK(visits.begins == 1);
    CHECK(visits.ends == 1);
}

TEST_CASE("filters keep a sensor from telling of what it is not to see", "[dynamics][sensor]") {
    World world = weightless();
    ShapeDef gate = asSensor(circle(1));
    gate.filter.mask = 2;
    world.add({.type = BodyType::Static, .shapes = {gate}});
    ShapeDef seen = circle(0.5), unseen = seen;
    seen.filter.category = 2;
    const BodyId ball = world.add({.shapes = {seen}});
    world.add({.position = {1, 0}, .shapes = {unseen}});
    world.step(dt);
    REQUIRE(world.sensorBegins().size() == 1);
    CHECK(world.sensorBegins()[0].visitor.body == ball);
}

TEST_CASE("a sensor weighs what its density says and stands in nothing's way", "[dynamics][sensor]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {segment({-5, 0}, {5, 0})}});
    ShapeDef wide = asSensor(plumb::box({2, 2}));
    const BodyId ball = world.add({.position = {0, 1}, .shapes = {circle(0.5), wide}});
    CHECK(std::fabs(world.body(ball).mass() - (16 + 0.25 * 3.14159265358979)) < 1e-9);
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    CHECK(std::fabs(world.body(ball).position().y() - 0.5) < 1e-3);
}

// Here nothing collides; for what is deflected see deflected_visits_test.cpp.
TEST_CASE("what sensors have told is what overlaps, in 200 steps of 30 worlds of flying shapes",
          "[dynamics][sensor][law]") {
    Random random(11);
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
    const auto keyOf = [](const ShapeId& s, const ShapeId& v) {
        return Key(s.body.index, s.number, v.body.index, v.number);
    };
    std::size_t changes = 0;
    for (int round = 0; round < 30; ++round) {
        World world({.gravity = {0, -1}});
        std::vector<BodyId> ids;
        std::vector<BodyDef> defs;
        for (int i = 0; i < 16; ++i) {
            BodyDef def;
            def.type = static_cast<BodyType>(random.integer(0, 2));
            def.position = Vec2(random.uniform(-6, 6), 0);
            def.position.y() = random.uniform(-6, 6);
            def.angle = random.uniform(-3, 3);
            if (def.type != BodyType::Static) {
                def.velocity.x() = random.uniform(-8, 8);
                def.velocity.y() = random.uniform(-8, 8);
                def.angularVelocity = random.uniform(-9, 9);
            }
            const int shapes = random.integer(1, 3);
            for (int s = 0; s < shapes; ++s) {
                const Vec2 at(random.uniform(-2, 2), 0);
                ShapeDef shape = circle(random.uniform(0.1, 1));
                if (random.integer(0, 1) == 0)
                    shape.shape = boxPolygon({random.uniform(0.1, 1), 0.4}, at);
                else if (random.integer(0, 2) == 0 && def.type != BodyType::Dynamic)
                    shape = chain({{-1, 0}, {0, 0.5}, {1, 0}, {2, 1}});
                shape.sensor = random.integer(0, 1) == 0;

                shape.filter.category = shape.sensor ? 2 : 1;
                shape.filter.mask = shape.sensor ? 1 : 2;  // only sensors see what is solid: nothing collides
                def.shapes.push_back(shape);
            }
            defs.push_back(def);
            ids.push_back(world.add(def));
        }
        std::set<Key> told;
        for (int tick = 0; tick < 200; ++tick) {
            world.step(dt);
            // one that passed within the step begins and ends in it
            for (const auto& e : world.sensorBegins()) told.insert(keyOf(e.sensor, e.visitor));
            for (const auto& e : world.sensorEnds()) told.erase(keyOf(e.sensor, e.visitor));
            changes += world.sensorBegins().size() + world.sensorEnds().size();
            std::set<Key> truth;
            for (std::size_t a = 0; a < ids.size(); ++a) {
                for (std::size_t b = 0; b < ids.size(); ++b) {
                    if (a == b || (defs[a].type == BodyType::Static && defs[b].type == BodyType::Static)) continue;
                    for (std::uint32_t i = 0; i < defs[a].shapes.size(); ++i) {
                        for (std::uint32_t j = 0; j < defs[b].shapes.size(); ++j) {
                            if (!defs[a].shapes[i].sensor || defs[b].shapes[j].sensor) continue;
                            const double apart = distance(defs[a].shapes[i].shape, world.body(ids[a]).pose(),
                                                          defs[b].shapes[j].shape, world.body(ids[b]).pose())
                                                     .separation;
                            if (apart <= 0) truth.insert(keyOf({ids[a], i}, {ids[b], j}));
                        }
                    }
                }
            }
            REQUIRE(told == truth);
        }
    }
    CHECK(changes > 1000);
}
