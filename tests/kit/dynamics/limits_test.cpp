// SPDX-License-Identifier: MIT
// What happens at each limit of the dynamics, and beyond it? The limits are on kit/plumb/dynamics/limits.md.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"

using plumb::BodyDef;
using plumb::BodyId;
using plumb::BodyType;
using plumb::Material;
using plumb::Vec2;
using plumb::World;
using plumb::test::dt;
using plumb::test::g;
using plumb::test::steps;

namespace {

const Material smoothAndElastic{.friction = 0, .restitution = 1};

World onFlatGround(const plumb::WorldDef& def = {.sleeping = false}) {
    World world(def);
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({60, 1})}});
    return world;
}

BodyId putBox(World& world, const Vec2& at, const Vec2& half, double density = 1) {
    return world.add({.position = at, .shapes = {plumb::box(half, {.density = density})}});
}

bool isAllowed(const BodyDef& def) {
    World world;
    try {
        world.add(def);
    } catch (const std::invalid_argument&) {
        return false;
    }
    return true;
}

/// By how much a slab, a hundred times as heavy as a box, sinks into so many of them [m].
double slabSinks(int boxes) {
    World world = onFlatGround();
    for (int i = 0; i < boxes; ++i) putBox(world, {1.5 * i, 0.5}, {0.5, 0.5});
    const double half = 0.75 * boxes;
    const BodyId slab = putBox(world, {0.75 * (boxes - 1), 1.5}, {half, 0.5}, 100 / (2 * half));
    steps(world, 180);
    return 1.5 - world.body(slab).position().y();
}

/// By how much a box so many times as heavy as those of a column of boxes of 1 m sinks into it in 5 s [m].
double boxSinks(int boxes, double ratio) {
    World world = onFlatGround();
    for (int i = 0; i < boxes; ++i) putBox(world, {0, i + 0.5}, {0.5, 0.5});
    const BodyId heavy = putBox(world, {0, boxes + 0.5}, {0.5, 0.5}, ratio);
    steps(world, 300);
    return boxes + 0.5 - world.body(heavy).position().y();
}

/// A disc that flies up and down between two walls, with 0.1 m to go from one to the other.
struct DiscInSlot {
    static constexpr double gap = 0.1, radius = 0.1, start = 0.05;  ///< from the lower wall [m]

    World world{{.gravity = {0, 0}, .sleeping = false}};
    BodyId wall, disc;
    double speed;

    explicit DiscInSlot(double initialSpeed) : speed(initialSpeed) {
        const auto shapes = {plumb::box({5, 1}, smoothAndElastic)};
        wall = world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = shapes});
        world.add({.type = BodyType::Static, .position = {0, 1 + 2 * radius + gap}, .shapes = shapes});
        disc = world.add({.position = {0, radius + start},
                          .velocity = {0, speed},
                          .shapes = {plumb::circle(radius, smoothAndElastic)}});
    }
    /// Above the lower wall, after a step [m].
    double height() {
        world.step(dt);
        return world.body(disc).position().y() - radius;
    }
    double heightByLaw() const {
        const double way = std::fmod(start + speed * dt, 2 * gap);
        return way < gap ? way : 2 * gap - way;
    }
    double speedKept() const { return world.body(disc).velocity().norm() / speed; }
};

/// The share of its energy that an elastic gas of 49 discs in a box keeps for ten steps.
double gasKeeps(double speed) {
    World world({.gravity = {0, 0}, .sleeping = false});
    for (const Vec2& side : {Vec2(2, 0), Vec2(-2, 0), Vec2(0, 2), Vec2(0, -2)}) {
        const Vec2 half = side.x() != 0 ? Vec2(1, 3) : Vec2(3, 1);
        world.add({.type = BodyType::Static, .position = side, .shapes = {plumb::box(half, smoothAndElastic)}});
    }
    std::vector<BodyId> discs;
    for (int i = 0; i < 49; ++i)
        discs.push_back(world.add({.position = Vec2(i % 7 - 3, i / 7 - 3) * 0.27,
                                   .velocity = speed * Vec2(std::cos(2.4 * i), std::sin(2.4 * i)),
                                   .shapes = {plumb::circle(0.1, smoothAndElastic)}}));
    steps(world, 10);
    double squares = 0;
    for (const BodyId disc : discs) squares += world.body(disc).velocity().squaredNorm();
    return squares / (49 * speed * speed);
}

/// Does a ball that is struck meet another one in the same step, if so many shapes lie beside its way?
bool meetsBehind(int shapes) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Vec2 along = Vec2(1, 1).normalized();
    const auto ball = [&](double place, double speed) {
        return world.add(
            {.position = place * along, .velocity = speed * along, .shapes = {plumb::circle(0.1, smoothAndElastic)}});
    };
    ball(0.5, 0);
    ball(0, 300);  // strikes it after 1 ms
    for (int i = 0; i < shapes; ++i)
        world.add({.type = BodyType::Static,
                   .position = (0.8 + 3.5 * i / shapes) * along + Vec2(0.2, -0.2),
                   .shapes = {plumb::circle(0.001)}});
    const BodyId behind = ball(3, 0);
    world.step(dt);
    return world.body(behind).velocity().norm() > 1;
}

/// Is a body that goes 100 times around a world in one sub-step stopped by a wall that it meets in this round?
bool isStoppedInRound(int round) {
    World world({.gravity = {0, 0}, .wrap = {.width = 1.0, .height = 1.0}, .solver = {.subSteps = 1}});
    const double rise = 0.5 / round;  // in a round, so that it comes by the wall once
    const plumb::ShapeDef point = plumb::circle(0.001, {.friction = 0});
    const BodyId body = world.add({.position = {0.1, 0.2}, .velocity = Vec2(1, rise) * 100 / dt, .shapes = {point}});
    world.add({.type = BodyType::Static, .position = {0.5, 0.7 + 0.4 * rise}, .shapes = {point}});
    world.step(dt);
    return world.body(body).velocity().norm() < 1;
}

/// The share of its energy that a disc keeps as it goes over an edge where a chain turns down.
double keptOverEdge(double degrees) {
    const double turn = degrees * std::numbers::pi / 180;
    World world({.sleeping = false});
    world.add(
        {.type = BodyType::Static,
         .shapes = {plumb::chain({20 * Vec2(std::cos(turn), -std::sin(turn)), {0, 0}, {-20, 0}}, {.friction = 0})}});
    const BodyId disc =
        world.add({.position = {-0.5, 0.1}, .velocity = {0.6, 0}, .shapes = {plumb::circle(0.1, {.friction = 0})}});
    steps(world, 70);
    const auto body = world.body(disc);
    return (0.5 * body.velocity().squaredNorm() + g * (body.position().y() - 0.1)) / (0.5 * 0.6 * 0.6);
}

/// In how many steps what rests, or slides without friction at this speed, falls asleep; 120 if not in 2 s.
int stepsToSleep(double speed) {
    World world({});
    const Material smooth{.friction = 0};
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {plumb::box({5, 1}, smooth)}});
    const BodyId box =
        world.add({.position = {0, 0.5}, .velocity = {speed, 0}, .shapes = {plumb::box({0.5, 0.5}, smooth)}});
    int count = 0;
    for (; count < 120 && world.body(box).awake(); ++count) world.step(dt);
    return count;
}

/// Does a one-way floor bear a box that is made so deep in it?
bool bearsAt(double depth) {
    World world;
    world.add({.type = BodyType::Static, .shapes = {{.shape = plumb::Segment{{-5, 0}, {5, 0}}, .oneWay = Vec2(0, 1)}}});
    const BodyId box = putBox(world, {0, 0.5 - depth}, {0.5, 0.5});
    steps(world, 60);
    return world.body(box).position().y() > 0.4;
}

/// Does a one-way line stop a disc that meets it squarely, if its one-way direction is so far off its normal?
bool stopsAt(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    World world({.gravity = {0, 0}});
    world.add(
        {.type = BodyType::Static,
         .shapes = {{.shape = plumb::Segment{{-50, 0}, {50, 0}}, .oneWay = Vec2(std::sin(angle), std::cos(angle))}}});
    const BodyId disc = world.add({.position = {0, 1}, .velocity = {0, -1}, .shapes = {plumb::circle(0.2)}});
    steps(world, 120);
    return world.body(disc).position().y() > 0;
}

/// Does a box at 3 m/s slide on over a step of this height in a floor of boxes?
bool slidesOver(double height) {
    World world;
    for (int i = 0; i < 10; ++i)
        world.add({.type = BodyType::Static,
                   .position = {2.0 * i, i < 4 ? -1 : -1 + height},
                   .shapes = {plumb::box({1, 1}, {.friction = 0})}});
    const BodyId box =
        world.add({.position = {1, 0.4}, .velocity = {3, 0}, .shapes = {plumb::box({0.4, 0.4}, {.friction = 0})}});
    steps(world, 240);
    return world.body(box).position().x() > 10;
}

/// The fastest at which a box comes out of the ground in which it was put [m/s].
double fastestOut(double depth) {
    World world = onFlatGround({.gravity = {0, 0}, .sleeping = false});
    const BodyId box = putBox(world, {0, 1 - depth}, {1, 1});
    double fastest = 0;
    for (int tick = 0; tick < 60; ++tick) {
        const double before = world.body(box).position().y();
        world.step(dt);
        fastest = std::max(fastest, (world.body(box).position().y() - before) / dt);
    }
    return fastest;
}

/// By how much a box sinks into the ground at this number of steps in a second [m].
double restingDepth(double rate) {
    World world = onFlatGround();
    const BodyId box = putBox(world, {0, 0.5}, {0.5, 0.5});
    plumb::test::run(world, 3, 1 / rate);
    return 0.5 - world.body(box).position().y();
}

/// Does a body that sleeps on one tile of a floor wake when another tile goes?
bool wakesOn(int tile, int gone) {
    plumb::TileMap map({.columns = 64, .rows = 1});
    for (int column = 0; column < 64; ++column) map.set({column, 0}, {.form = plumb::TileForm::Full});
    World world;
    const BodyId ground = world.add({.type = BodyType::Static, .shapes = {plumb::tiles(map)}});
    const BodyId box = putBox(world, {tile + 0.5, 1.4}, {0.4, 0.4});
    steps(world, 60);
    REQUIRE_FALSE(world.body(box).awake());
    world.setTile(world.body(ground).shapes().front(), {gone, 0}, {});
    return world.body(box).awake();
}

}  // namespace

TEST_CASE("a slab a hundred times as heavy as a box stands on eleven boxes, and sinks into twelve by 2 mm",
          "[dynamics][limits]") {
    // Each box bears a twelfth of the slab on a spring of 30 Hz for its own mass: m g / k; the spring's mass, that of
    // both bodies together, is at least half of it.
    const double sinks = 100.0 / 12 * g / std::pow(2 * std::numbers::pi * 30, 2);
    CHECK(slabSinks(11) < 1e-4);
    CHECK(slabSinks(12) > 0.5 * sinks);
}

TEST_CASE("a box of 15.9 times the mass of the one below sinks in by 3.6 mm, of 16.1 times by 0.2 mm",
          "[dynamics][limits]") {
    CHECK(boxSinks(1, 15.9) > 3e-3);
    CHECK(boxSinks(1, 16.1) < 3e-4);
}

TEST_CASE("a column of seven boxes bears a thousand times the mass of one, a column of eight falls over",
          "[dynamics][limits]") {
    CHECK(boxSinks(7, 1000) < 3e-3);
    CHECK(boxSinks(8, 1000) > 1);
}

TEST_CASE("an elastic disc meets each of two walls 64 times in a step, and waits at one if there were more",
          "[dynamics][limits]") {
    DiscInSlot fewer(127 * DiscInSlot::gap / dt), more(200 * DiscInSlot::gap / dt);
    CHECK(std::fabs(fewer.height() - fewer.heightByLaw()) < 1e-6);
    CHECK(std::fabs(fewer.speedKept() - 1) < 1e-9);
    const double height = more.height();
    CHECK(std::min(height, DiscInSlot::gap - height) < 1e-3);
    CHECK(std::fabs(more.heightByLaw() - 0.5 * DiscInSlot::gap) < 1e-6);
    CHECK(std::fabs(more.speedKept() - 1) < 1e-6);
}

TEST_CASE("a disc on a slide meets walls 23 times in a sub-step, and waits at one after the 24th",
          "[dynamics][limits]") {
    for (const double times : {23.0, 25.5}) {
        DiscInSlot slot(4 * times * DiscInSlot::gap / dt);
        slot.world.join(plumb::PrismaticJointDef{.bodyA = slot.wall,
                                                 .bodyB = slot.disc,
                                                 .anchor = slot.world.body(slot.disc).position(),
                                                 .axis = {0, 1},
                                                 .collideConnected = true});
        const double height = slot.height();
        // It is stopped 0.1 mm before each wall: the way from one to the other is shorter by twice that.
        if (times < 24) CHECK(std::fabs(height - slot.heightByLaw()) < 4 * times * 2e-4);
        if (times > 24) CHECK(std::min(height, DiscInSlot::gap - height) < 2e-4);
        CHECK(std::fabs(slot.speedKept() - 1) < 1e-3);
    }
}

TEST_CASE("an elastic gas of 49 discs keeps its energy at 10 m/s, and has spent its predictions at 500 m/s",
          "[dynamics][limits]") {
    CHECK(std::fabs(gasKeeps(10) - 1) < 1e-9);
    CHECK(gasKeeps(500) < 0.9);
}

TEST_CASE("a struck ball meets another one past 190 shapes, and passes it past 210", "[dynamics][limits]") {
    CHECK(meetsBehind(190));
    CHECK_FALSE(meetsBehind(210));
}

TEST_CASE("a body is stopped by a wall that it meets in its 63rd round in a sub-step, and not in its 66th",
          "[dynamics][limits][wrap]") {
    CHECK(isStoppedInRound(62));
    CHECK_FALSE(isStoppedInRound(65));
}

TEST_CASE("a disc keeps its energy over an edge of 14.4 degrees, and loses more than 5 % over one of 14.6",
          "[dynamics][limits][chain]") {
    CHECK(std::fabs(keptOverEdge(14.4) - 1) < 1e-6);  // sin 14.48 degrees is 0.25
    CHECK(keptOverEdge(14.6) < 0.95);
}

TEST_CASE("what rests falls asleep after half a second, what slides at 0.049 m/s too, at 0.051 m/s never",
          "[dynamics][limits][sleep]") {
    CHECK(std::abs(stepsToSleep(0) - 30) <= 1);
    CHECK(std::abs(stepsToSleep(0.049) - 30) <= 1);
    CHECK(stepsToSleep(0.051) == 120);
}

TEST_CASE("a one-way floor bears a box that is 4.9 mm deep in it, and lets one fall that is 5.1 mm deep",
          "[dynamics][limits]") {
    CHECK(bearsAt(4.9e-3));
    CHECK_FALSE(bearsAt(5.1e-3));
}

TEST_CASE("a one-way line is solid up to 59 degrees off its direction, and not at 61", "[dynamics][limits]") {
    CHECK(stopsAt(59));
    CHECK_FALSE(stopsAt(61));
}

TEST_CASE("a box slides over a step of 1.9 mm in a floor of boxes, and is stopped by one of 5 mm",
          "[dynamics][limits]") {
    CHECK(slidesOver(1.9e-3));
    CHECK_FALSE(slidesOver(5e-3));
}

TEST_CASE("a box that was put into the ground comes out at up to 3 m/s, however deep it is", "[dynamics][limits]") {
    // Besides, the spring pushes out 1 cm of it, at w / (2 z + h w) times that (softness.h).
    const double w = 2 * std::numbers::pi * 60, spring = 0.01 * w / (2 * 10 + w * dt / 4);
    CHECK(fastestOut(0.1) < 8 * 0.1 + spring);
    CHECK(fastestOut(0.3) < 8 * 0.3 + spring);
    CHECK(fastestOut(0.9) > 3);
    CHECK(fastestOut(0.9) < 3 + spring);
}

TEST_CASE("a box rests as deep at 240 steps a second as at 60, and four times as deep at 30", "[dynamics][limits]") {
    // The ground's springs of 60 Hz are at most a quarter of the sub-steps' rate: 30 Hz there, half of 60.
    CHECK(std::fabs(restingDepth(240) / restingDepth(60) - 1) < 0.02);
    CHECK(std::fabs(restingDepth(30) / restingDepth(60) - 4) < 0.1);
}

TEST_CASE("a body flies on at 1e14 m/s up to 1e15 m from the origin, and is put in quarantine there",
          "[dynamics][limits]") {
    for (const double start : {9.97e14, 9.99e14}) {  // a step takes it 1.67e12 m further
        World world({.gravity = {0, 0}});
        const BodyId body = world.add({.position = {start, 0}, .velocity = {1e14, 0}, .shapes = {plumb::circle(1)}});
        world.step(dt);
        CHECK(world.body(body).quarantined() == (start > 9.98e14));
        CHECK((world.body(body).velocity().x() > 0) == (start < 9.98e14));
    }
}

TEST_CASE("shapes and anchors up to 1e5 m from their body, and masses of 1e-12 to 1e12 kg, are allowed, and no more",
          "[dynamics][limits][errors]") {
    for (const double length : {1e5, 1.0001e5}) {
        CHECK(isAllowed({.type = BodyType::Static, .shapes = {plumb::box({length, 1})}}) == (length <= 1e5));
        World world;
        const BodyId ground = world.add({.type = BodyType::Static}), disc = world.add({.shapes = {plumb::circle(1)}});
        const plumb::RevoluteJointDef hinge{.bodyA = ground, .bodyB = disc, .anchor = {length, 0}};
        if (length <= 1e5) CHECK_NOTHROW(world.join(hinge));
        if (length > 1e5) CHECK_THROWS_AS(world.join(hinge), std::invalid_argument);
    }
    for (const double mass : {0.9e-12, 1e-12, 1e12, 1.1e12})
        CHECK(isAllowed({.mass = plumb::Mass{mass, {0, 0}, mass}}) == (mass >= 1e-12 && mass <= 1e12));
}

TEST_CASE("a step of 1 s is taken, and one of 1.001 s refused, one of 0.9 ns meets nothing, one of 1.1 ns does",
          "[dynamics][limits]") {
    for (const double step : {1.0, 1.001, 0.9e-9, 1.1e-9}) {
        World world = onFlatGround({.gravity = {0, 0}});
        const BodyId box =
            world.add({.position = {0, 0.4999}, .velocity = {0, -1e6}, .shapes = {plumb::box({0.5, 0.5})}});
        if (step > 1) CHECK_THROWS_AS(world.step(step), std::invalid_argument);
        if (step > 1) continue;
        world.step(step);
        CHECK((world.body(box).velocity().y() == -1e6) == (step < 1e-9));
    }
}

TEST_CASE("a body wakes when a tile of its block of 16 tiles in the floor goes, and not for one of the next but one",
          "[dynamics][limits][tiles]") {
    CHECK(wakesOn(17, 30));
    CHECK_FALSE(wakesOn(17, 49));
    CHECK_FALSE(wakesOn(30, 50));
}
