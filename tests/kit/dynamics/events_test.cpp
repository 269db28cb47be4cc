// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

BodyId addFloor(World& world) {
    return world.add({.type = BodyType::Static, .shapes = {segment({-50, 0}, {50, 0})}});
}

/// All hits of the next steps.
std::vector<ContactHit> contactHitsOf(World& world, int ticks) {
    std::vector<ContactHit> hits;
    for (int tick = 0; tick < ticks; ++tick) {
        world.step(dt);
        hits.insert(hits.end(), world.contactHits().begin(), world.contactHits().end());
    }
    return hits;
}

}  // namespace

// An impact by itself is found to 1e-12 m, and so is its speed.
TEST_CASE("a ball at e = 0.5 dropped from 5 m hits at 9.904 m/s, where it lands", "[dynamics][events]") {
    World world;
    addFloor(world);
    const BodyId ball = world.add({.position = {3, 5.5}, .shapes = {circle(0.5, {.restitution = 0.5})}});
    const std::vector<ContactHit> hits = contactHitsOf(world, 62);
    REQUIRE(hits.size() == 1);
    CHECK(std::fabs(hits[0].approachSpeed - std::sqrt(2 * g * 5)) < 1e-9);
    CHECK((hits[0].point - Vec2(3, 0)).norm() < 1e-9);
    CHECK((hits[0].shapeB.body == ball ? hits[0].normal : Vec2(-hits[0].normal)) == Vec2(0, 1));
}

// The solver knows the speed at the step's start: up to g dt less.
TEST_CASE("a box that lands flat at 5 m/s is one hit, and none while it lies", "[dynamics][events]") {
    World world;
    addFloor(world);
    world.add({.position = {0, 0.5 + 25 / (2 * g)}, .shapes = {plumb::box({0.5, 0.5})}});
    const std::vector<ContactHit> hits = contactHitsOf(world, 240);
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].approachSpeed > 5 - 1.1 * g * dt);
    CHECK(hits[0].approachSpeed < 5 + 1e-3);
}

// Each is told half way between the surfaces. They are 1 cm apart at most when a touch is no longer foreseen, and it
// may come in the half that the other shape does.
TEST_CASE("what lands in pairs at 1 to 50 m/s is told to touch within 5 mm of half way between it and the floor",
          "[dynamics][events]") {
    const ShapeDef shapes[] = {circle(0.25), plumb::box({0.3, 0.25}), capsule({0, -0.1}, {0, 0.1}, 0.15)};
    double farthest = 0, between = 0;
    int told = 0;
    const auto land = [&](double speed, double height, const ShapeDef& shape) {
        World world;
        const BodyId floor = addFloor(world);
        const BodyId low = world.add({.position = {3, height}, .velocity = {0, -speed}, .shapes = {shape}});
        world.add({.position = {3, height + 0.5}, .velocity = {0, -speed}, .shapes = {shape}});
        for (int tick = 0; tick < 30; ++tick) {
            world.step(dt);
            std::vector<Contact> contacts = world.body(low).contacts();
            std::erase_if(contacts, [&](const auto& c) { return c.shapeA.body != floor && c.shapeB.body != floor; });
            if (contacts.empty()) continue;
            for (const ContactPoint& p : contacts[0].points)
                farthest = std::max(farthest, std::fabs(p.position.y() - p.separation / 2));
            for (const auto& begin : world.contactBegins()) {
                if (begin.shapeA.body != floor && begin.shapeB.body != floor) continue;
                double off = 1;
                for (const ContactPoint& p : contacts[0].points) off = std::min(off, (begin.point - p.position).norm());
                between = std::max(between, off);
                ++told;
            }
        }
    };
    for (const double speed : {1.0, 5.0, 20.0, 50.0})
        for (const double height : {0.27, 0.31, 0.4, 0.5, 0.6})
            for (const ShapeDef& shape : shapes) land(speed, height, shape);
    CHECK(told >= 60);
    CHECK(farthest < 0.005);
    CHECK(between < 1e-9);
}

TEST_CASE("a box that lies on the floor and is struck down at 10 m/s is a hit, and no touch begins",
          "[dynamics][events]") {
    World world;
    addFloor(world);
    const BodyId box = world.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    CHECK(contactHitsOf(world, 120).empty());
    world.body(box).applyImpulse({0, -10 * world.body(box).mass()});
    world.step(dt);
    REQUIRE(world.contactHits().size() == 1);
    CHECK(std::fabs(world.contactHits()[0].approachSpeed - 10) < 1e-3);
    CHECK(world.contactBegins().empty());
}

TEST_CASE("a touch at 0.9 m/s is no hit at the default of 1 m/s, is at 0.8, and nothing is at infinity",
          "[dynamics][events]") {
    const auto count = [](double hitSpeed) {
        World world({.gravity = {0, 0}, .hitSpeed = hitSpeed});
        world.add({.type = BodyType::Static, .shapes = {segment({0, -5}, {0, 5})}});
        world.add({.position = {-1, 0}, .velocity = {0.9, 0}, .shapes = {circle(0.5)}});
        return contactHitsOf(world, 60).size();
    };
    CHECK(count(1) == 0);
    CHECK(count(0.8) == 1);
    CHECK(count(std::numeric_limits<double>::infinity()) == 0);
    CHECK_THROWS_WITH(World({.hitSpeed = -1}), containsText("WorldDef.hitSpeed: -1"));
    CHECK_THROWS_WITH(World({.hitSpeed = std::nan("")}), containsText("WorldDef.hitSpeed: nan"));
}

TEST_CASE("what is awake is told as moved in the order of slots, what is not is left out", "[dynamics][events]") {
    World world({.gravity = {0, 0}});
    addFloor(world);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 4; ++i)
        bodies.push_back(world.add({.position = {2.0 * i, 5}, .awake = i != 1, .shapes = {circle(0.5)}}));
    const BodyId lift = world.add({.type = BodyType::Kinematic, .velocity = {1, 0}, .shapes = {circle(0.5)}});
    world.step(dt);
    const BodyId later = world.add({.position = {0, 50}, .shapes = {circle(0.5)}});
    std::vector<BodyMoved> moves = world.moves();
    REQUIRE(moves.size() == 4);
    CHECK(moves[0].body == bodies[0]);
    CHECK(moves[1].body == bodies[2]);
    CHECK(moves[2].body == bodies[3]);
    CHECK(moves[3].body == lift);
    CHECK(moves[3].pose.position == world.body(lift).position());
    world.remove(bodies[2]);
    world.add({.position = {0, 60}, .shapes = {circle(0.5)}});  // takes its slot
    moves = world.moves();
    CHECK(moves.size() == 3);
    CHECK(moves[1].body == bodies[3]);
    world.step(dt);
    CHECK(world.moves().size() == 5);
    CHECK(world.moves()[4].body == later);
}

TEST_CASE("a box that comes to rest is told as fallen asleep once, and then no more", "[dynamics][events]") {
    World world;
    addFloor(world);
    const BodyId box = world.add({.position = {0, 1}, .shapes = {plumb::box({0.5, 0.5})}});
    int moved = 0, slept = 0;
    for (int tick = 0; tick < 240; ++tick) {
        const bool awake = world.body(box).awake();
        world.step(dt);
        CHECK(world.moves().size() == (awake ? 1 : 0));
        for (const BodyMoved& move : world.moves()) {
            ++moved;
            slept += move.fellAsleep ? 1 : 0;
            CHECK(move.fellAsleep == !world.body(box).awake());
        }
    }
    CHECK(moved > 10);
    CHECK(slept == 1);
}
