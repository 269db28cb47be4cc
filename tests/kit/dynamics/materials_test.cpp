// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// A floor along x, turned by tilt about the origin.
World tiltedFloorWorld(const Material& material, double tilt = 0) {
    World world({.gravity = {0, -g}});
    world.add({.type = BodyType::Static,
               .position = 0.5 * Vec2(std::sin(tilt), -std::cos(tilt)),
               .angle = tilt,
               .shapes = {plumb::box({100, 0.5}, material)}});
    return world;
}

/// Where a thing is after a time t, and how fast, that slows down at a until it stands.
struct Stopping {
    double way = 0, speed = 0;
};

Stopping stopping(double speed, double a, double t) {
    const double moving = std::min(t, speed / a);
    return {speed * moving - 0.5 * a * moving * moving, speed - a * moving};
}

}  // namespace

// About the point it rolls on, a disc has I = 3/2 m r^2, and is slowed by the torque c r m g: a = 2/3 c g.
// The soft contact takes a step or two to carry the weight, and rolling, as sliding, is of second order in the step:
// below a millimetre over the way of 1.53 m.
TEST_CASE("a disc with rolling resistance 0.2 slows down at 2/3 0.2 g = 1.308 m/s^2 and stands after 1.53 s",
          "[dynamics][law][materials]") {
    World world = tiltedFloorWorld({.friction = 0.8});
    const BodyId disc = world.add({.position = {0, 0.5},
                                   .velocity = {2, 0},
                                   .angularVelocity = -4,
                                   .shapes = {circle(0.5, {.friction = 0.8, .rollingResistance = 0.2})}});
    for (int tick = 1; tick <= 150; ++tick) {
        world.step(dt);
        const Stopping truth = stopping(2, 2.0 / 3 * 0.2 * g, tick * dt);
        CHECK(std::fabs(world.body(disc).velocity().x() - truth.speed) < 5e-3);
        CHECK(std::fabs(world.body(disc).position().x() - truth.way) < 2e-3);
        CHECK(std::fabs(world.body(disc).angularVelocity() + truth.speed / 0.5) < 1e-2);
    }
    CHECK_FALSE(world.body(disc).awake());
}

TEST_CASE("rolling resistance of the floor holds as well as the disc's, the larger counts", "[dynamics][materials]") {
    const auto speedAfter = [](double ofFloor, double ofDisc) {
        World world = tiltedFloorWorld({.friction = 0.8, .rollingResistance = ofFloor});
        const BodyId disc = world.add({.position = {0, 0.5},
                                       .velocity = {2, 0},
                                       .angularVelocity = -4,
                                       .shapes = {circle(0.5, {.friction = 0.8, .rollingResistance = ofDisc})}});
        for (int tick = 0; tick < 30; ++tick) world.step(dt);
        return world.body(disc).velocity().x();
    };
    const double both = speedAfter(0.2, 0.2);
    CHECK(std::fabs(both - (2 - 2.0 / 3 * 0.2 * g * 0.5)) < 5e-3);
    CHECK(speedAfter(0.2, 0) == both);
    CHECK(speedAfter(0.1, 0.2) == both);
    CHECK(speedAfter(0, 0) > 1.999);
}

// It holds as long as c r m g cos(tilt) can balance m g sin(tilt) r: tan(tilt) <= c.
TEST_CASE("a disc with rolling resistance 0.3 stays on 15 degrees and rolls down 20 at 2/3 g (sin - 0.3 cos)",
          "[dynamics][law][materials]") {
    for (const double degrees : {15.0, 20.0}) {
        const double tilt = degrees * std::numbers::pi / 180;
        World world = tiltedFloorWorld({.friction = 1}, tilt);
        const Vec2 up(-std::sin(tilt), std::cos(tilt)), down(-std::cos(tilt), -std::sin(tilt));
        const BodyId disc =
            world.add({.position = 0.5 * up, .shapes = {circle(0.5, {.friction = 1, .rollingResistance = 0.3})}});
        for (int tick = 0; tick < 120; ++tick) world.step(dt);
        const double a = std::max(0.0, 2.0 / 3 * g * (std::sin(tilt) - 0.3 * std::cos(tilt)));
        const double way = (world.body(disc).position() - 0.5 * up).dot(down);
        CHECK(std::fabs(way - 0.5 * a * 4) < 5e-3);
    }
}

// Until it has the belt's speed v, friction is mu m g all the time: v^2 / (2 mu g) of way in v / (mu g) of time.
TEST_CASE("a box on a belt of 2 m/s is drawn along at mu g until it has 2 m/s, and keeps that",
          "[dynamics][law][materials]") {
    for (const double speed : {2.0, -2.0}) {
        World world = tiltedFloorWorld({.friction = 0.5, .surfaceSpeed = speed});
        const BodyId box = world.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5}, {.friction = 0.5})}});
        for (int tick = 1; tick <= 120; ++tick) {
            world.step(dt);
            const double t = tick * dt;
            const double a = 0.5 * g;
            const double drawn = std::min(t, 2 / a);
            const double way = 0.5 * a * drawn * drawn + 2 * (t - drawn);
            const double sign = speed > 0 ? 1 : -1;  // the top of what runs clockwise runs to +x
            CHECK(std::fabs(sign * world.body(box).velocity().x() - a * drawn) < 2e-2);
            CHECK(std::fabs(sign * world.body(box).position().x() - way) < 1e-2);
        }
        CHECK(std::fabs(std::fabs(world.body(box).velocity().x()) - 2) < 1e-3);
        CHECK(world.body(box).awake());
    }
}

TEST_CASE("a belt runs clockwise: its top to +x, its bottom to -x, its right side down, its left side up",
          "[dynamics][materials]") {
    struct Side {
        Vec2 outward, along;
    };
    for (const Side& side :
         {Side{{0, 1}, {1, 0}}, Side{{0, -1}, {-1, 0}}, Side{{1, 0}, {0, -1}}, Side{{-1, 0}, {0, 1}}}) {
        for (const bool line : {false, true}) {
            World world({.gravity = -g * side.outward});
            const Material belt{.friction = 1, .surfaceSpeed = 1};
            const Vec2 end = 20 * side.along;
            world.add(
                {.type = BodyType::Static, .shapes = {line ? segment(-end, end, belt) : plumb::box({10, 10}, belt)}});
            const Vec2 start = (line ? 0.5 : 10.5) * side.outward;
            const BodyId box = world.add({.position = start, .shapes = {plumb::box({0.5, 0.5}, {.friction = 1})}});
            for (int tick = 0; tick < 60; ++tick) world.step(dt);
            CHECK((world.body(box).velocity() - side.along).norm() < 1e-3);
        }
    }
}

// J pulls its lowest point along until that has the belt's speed: J/m + (J r) r / (m r^2 / 2) = 3 J/m = v.
TEST_CASE("a disc set on a belt of 3 m/s ends up at 1 m/s, spinning at 2 m/s over its radius",
          "[dynamics][law][materials]") {
    World world = tiltedFloorWorld({.friction = 0.5, .surfaceSpeed = 3});
    const BodyId disc = world.add({.position = {0, 0.25}, .shapes = {circle(0.25, {.friction = 0.5})}});
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    CHECK(std::fabs(world.body(disc).velocity().x() - 1) < 5e-3);
    CHECK(std::fabs(world.body(disc).angularVelocity() - 8) < 4e-2);
}

TEST_CASE("a box whose own belt runs at 1 m/s drives itself to +x at 1 m/s", "[dynamics][materials]") {
    World world = tiltedFloorWorld({.friction = 0.8});
    const BodyId tank =
        world.add({.position = {0, 0.5}, .shapes = {plumb::box({1, 0.5}, {.friction = 0.8, .surfaceSpeed = 1})}});
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    CHECK(std::fabs(world.body(tank).velocity().x() - 1) < 1e-3);
}

namespace {

struct Rule {
    Mix mix;
    double of02and08, of04and09;
};

constexpr std::array rules{Rule{Mix::Average, 0.5, 0.65}, Rule{Mix::GeometricMean, 0.4, 0.6},
                           Rule{Mix::Minimum, 0.2, 0.4}, Rule{Mix::Product, 0.16, 0.36}, Rule{Mix::Maximum, 0.8, 0.9}};

/// Of the two that a pair names, the later in the list holds.
const Rule& ruling(std::size_t a, std::size_t b) {
    return rules[std::max(a, b)];
}

}  // namespace

// v = 4 - mu g t; the soft contact carries the weight from the second step on, which is 2e-3 of the 0.3 s.
TEST_CASE("friction 0.2 on 0.8 is 0.5, 0.4, 0.2, 0.16 or 0.8 by the pair's rule, of two the later",
          "[dynamics][law][materials]") {
    for (std::size_t a = 0; a < rules.size(); ++a) {
        for (std::size_t b = 0; b < rules.size(); ++b) {
            World world = tiltedFloorWorld({.friction = 0.8, .frictionMix = rules[a].mix});
            const Material material{.friction = 0.2, .frictionMix = rules[b].mix};
            const BodyId box =
                world.add({.position = {0, 0.5}, .velocity = {4, 0}, .shapes = {plumb::box({2, 0.5}, material)}});
            for (int tick = 0; tick < 18; ++tick) world.step(dt);
            CHECK(std::fabs(world.body(box).velocity().x() - (4 - ruling(a, b).of02and08 * g * 0.3)) < 1e-2);
        }
    }
}

TEST_CASE("restitution 0.4 on 0.9 is 0.65, 0.6, 0.4, 0.36 or 0.9 by the pair's rule, of two the later",
          "[dynamics][law][materials]") {
    for (std::size_t a = 0; a < rules.size(); ++a) {
        for (std::size_t b = 0; b < rules.size(); ++b) {
            World world({.gravity = {0, 0}});
            world.add({.type = BodyType::Static,
                       .shapes = {segment({-5, 0}, {5, 0}, {.restitution = 0.9, .restitutionMix = rules[a].mix})}});
            const Material material{.restitution = 0.4, .restitutionMix = rules[b].mix};
            const BodyId disc = world.add({.position = {0, 1}, .velocity = {0, -3}, .shapes = {circle(0.5, material)}});
            for (int tick = 0; tick < 30; ++tick) world.step(dt);
            CHECK(std::fabs(world.body(disc).velocity().y() - 3 * ruling(a, b).of04and09) < 1e-9);
        }
    }
}

TEST_CASE("a group above 0 collides whatever the masks say, one below 0 never, and two groups by their masks",
          "[dynamics][materials]") {
    struct Case {
        Filter floor, ball;
        bool held;
    };
    const Filter deaf{.category = 1, .mask = 0};
    const auto with = [](Filter filter, int group) {
        filter.group = group;
        return filter;
    };
    const std::uint64_t high = std::uint64_t{1} << 63;
    for (const Case& c :
         {Case{{}, {}, true}, Case{deaf, {}, false}, Case{with(deaf, 3), with({}, 3), true},
          Case{with(deaf, 3), with({}, 4), false}, Case{with(deaf, 3), with({}, 0), false},
          Case{with({}, -3), with({}, -3), false}, Case{with({}, -3), with({}, -4), true},
          Case{with({}, 3), with({}, 4), true}, Case{with({}, -3), with({}, 3), true},
          Case{{.category = high}, {.mask = high}, true}, Case{{.category = high}, {.mask = 1}, false}}) {
        World world;
        world.add(
            {.type = BodyType::Static, .shapes = {ShapeDef{.shape = Segment{{-5, 0}, {5, 0}}, .filter = c.floor}}});
        ShapeDef disc = circle(0.5);
        disc.filter = c.ball;
        const BodyId ball = world.add({.position = {0, 1}, .shapes = {disc}});
        for (int tick = 0; tick < 90; ++tick) world.step(dt);
        CHECK((world.body(ball).position().y() > 0.4) == c.held);
    }
}
