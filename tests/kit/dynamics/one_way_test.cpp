// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

ShapeDef oneWay(ShapeDef shape, const Vec2& direction = {0, 1}) {
    shape.oneWay = direction;
    return shape;
}

/// Three kinds of platform with its top at y = 0.
std::vector<ShapeDef> platforms(const Material& material = {}) {
    ShapeDef thick = plumb::box({5, 0.1}, material);
    thick.shape = boxPolygon({5, 0.1}, {0, -0.1});
    return {oneWay(segment({-5, 0}, {5, 0}, material)), oneWay(chain({{-5, 0}, {-2, 0}, {1, 0}, {5, 0}}, material)),
            oneWay(thick)};
}

/// Players half a metre high above and below their centre.
std::vector<ShapeDef> players(const Material& material = {}) {
    return {plumb::box({0.3, 0.5}, material), capsule({0, -0.2}, {0, 0.2}, 0.3, material), circle(0.5, material)};
}

template <class Visit>
void forEachPairing(Visit&& visit) {
    for (const int lanes : {1, 4, 8, 16})
        for (const ShapeDef& platform : platforms())
            for (const ShapeDef& player : players()) visit(lanes, platform, player);
}

World worldOf(int lanes) {
    return World({.solver = {.lanes = lanes}});
}

/// A jump from the ground 3 m below that reaches so high with the feet.
BodyId jump(World& world, const ShapeDef& player, double feet) {
    return world.add({.position = {0, -2.5},
                      .velocity = {0, std::sqrt(2 * g * (3 + feet))},
                      .fixedRotation = true,
                      .shapes = {player}});
}

}  // namespace

TEST_CASE("a player who jumps 30 cm above a platform from below flies free until he lands on it, and stands",
          "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        world.add({.type = BodyType::Static, .shapes = {platform}});
        const BodyId player = jump(world, shape, 0.3);
        const double v = world.body(player).velocity().y();
        double top = -10;
        for (int tick = 1; tick < 60; ++tick) {
            world.step(dt);
            const double t = tick * dt, y = world.body(player).position().y();
            top = std::max(top, y);
            const bool landed = t > v / g + std::sqrt(2 * 0.3 / g) - dt;
            if (landed) continue;
            CHECK(std::fabs(y - (-2.5 + v * t - 0.5 * g * t * t)) < 1e-9);
            CHECK(world.contactBegins().empty());
        }
        CHECK(top > 0.79);
        steps(world, 120);
        CHECK(std::fabs(world.body(player).position().y() - 0.5) < 1e-3);
        CHECK(world.body(player).contacts().size() >= 1);
    });
}

TEST_CASE("a player whose jump ends within a platform falls back through it", "[dynamics][one way]") {
    for (const double feet : {-0.9, -0.5, -0.3, -0.02}) {
        forEachPairing([feet](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
            World world = worldOf(lanes);
            world.add({.type = BodyType::Static, .shapes = {platform}});
            const BodyId player = jump(world, shape, feet);
            const double v = world.body(player).velocity().y();
            for (int tick = 1; tick <= 120; ++tick) {
                world.step(dt);
                const double t = tick * dt;
                REQUIRE(std::fabs(world.body(player).position().y() - (-2.5 + v * t - 0.5 * g * t * t)) < 1e-9);
            }
        });
    }
}

TEST_CASE("a player whose jump ends 3 mm above a platform stands on it", "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        world.add({.type = BodyType::Static, .shapes = {platform}});
        const BodyId player = jump(world, shape, 0.003);
        steps(world, 120);
        CHECK(std::fabs(world.body(player).position().y() - 0.5) < 1e-3);
    });
}

TEST_CASE("an edit of a one-way shape decides anew who stands on it", "[dynamics][one way]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {segment({-5, 0}, {5, 0})}});
    const BodyId box = world.add({.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    steps(world, 90);
    world.shape({floor, 0}).set(oneWay(segment({-5, 0}, {5, 0})));
    CHECK(world.body(box).awake());
    steps(world, 90);
    CHECK(std::fabs(world.body(box).position().y() - 0.5) < 1e-3);
    world.shape({floor, 0}).set(oneWay(segment({-5, 0}, {5, 0}), {0, -1}));
    steps(world, 60);
    CHECK(world.body(box).position().y() < -2);
}

TEST_CASE("a player on a platform jumps 10 times and lands on it each time", "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        world.add({.type = BodyType::Static, .shapes = {platform}});
        const BodyId player = world.add({.position = {0, 1}, .fixedRotation = true, .shapes = {shape}});
        steps(world, 60);
        for (int i = 0; i < 10; ++i) {
            world.body(player).setVelocity({0, 1 + 0.4 * i});
            steps(world, 80);
            REQUIRE(std::fabs(world.body(player).position().y() - 0.5) < 1e-3);
        }
    });
}

TEST_CASE("a player who walks off a platform falls beside it and does not catch on its edge when he turns back",
          "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        world.add({.type = BodyType::Static, .shapes = {platform}});
        const BodyId player = world.add({.position = {4, 0.5}, .fixedRotation = true, .shapes = {shape}});
        bool below = false;
        for (int tick = 0; tick < 240; ++tick) {
            below = below || world.body(player).position().y() < 0.3;
            world.body(player).setVelocity({below ? -2.0 : 2.0, world.body(player).velocity().y()});
            world.step(dt);
        }
        CHECK(below);
        CHECK(world.body(player).position().x() < 4);
        CHECK(world.body(player).position().y() < -5);
    });
}

TEST_CASE("a lift with one-way floor carries a player up and down at 1 m/s, within 5 mm", "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        const BodyId lift = world.add({.type = BodyType::Kinematic, .shapes = {platform}});
        const BodyId player = world.add({.position = {0, 0.5}, .fixedRotation = true, .shapes = {shape}});
        for (int tick = 0; tick < 480; ++tick) {
            world.body(lift).setVelocity({0, tick / 120 % 2 == 0 ? 1.0 : -1.0});
            world.step(dt);
            const double gap = world.body(player).position().y() - 0.5 - world.body(lift).position().y();
            REQUIRE(gap > -5e-3);
            REQUIRE(gap < 0.25);  // where it turns down at once he falls after it: v^2 / 2 g, twice 1 m/s
        }
        steps(world, 60);
    });
}

TEST_CASE("a lift comes down through a player who stands below, and takes him up when it has", "[dynamics][one way]") {
    forEachPairing([](int lanes, const ShapeDef& platform, const ShapeDef& shape) {
        World world = worldOf(lanes);
        world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {segment({-5, 0}, {5, 0})}});
        const BodyId lift = world.add({.type = BodyType::Kinematic, .position = {0, 1}, .shapes = {platform}});
        const BodyId player = world.add({.position = {0, -0.5}, .fixedRotation = true, .shapes = {shape}});
        world.body(lift).setVelocity({0, -1});
        for (int tick = 0; tick < 150; ++tick) {
            world.step(dt);
            REQUIRE(std::fabs(world.body(player).position().y() + 0.5) < 5e-3);
        }
        world.body(lift).setVelocity({0, 1});
        steps(world, 150);
        CHECK(world.body(player).position().y() > 0.4);
    });
}

TEST_CASE("a platform tilted by 30 degrees holds a block from above and lets one through from below",
          "[dynamics][one way]") {
    for (const ShapeDef& platform : platforms({.friction = 1})) {
        World world;
        const double tilt = 0.5235987755982988;
        const Rot turn = Rot::fromAngle(tilt);
        world.add({.type = BodyType::Static, .angle = tilt, .shapes = {platform}});
        const ShapeDef block = plumb::box({0.3, 0.3}, {.friction = 1});
        // They cannot turn: what lands on a slope may tumble down.
        const BodyId above =
            world.add({.position = turn * Vec2(-2, 0.5), .angle = tilt, .fixedRotation = true, .shapes = {block}});
        const BodyId below = world.add({.position = turn * Vec2(2, -1),
                                        .angle = tilt,
                                        .velocity = {0, 7},
                                        .fixedRotation = true,
                                        .shapes = {block}});
        steps(world, 40);
        CHECK((turn.inverse() * world.body(below).position()).y() > 0.3);
        steps(world, 200);
        for (const BodyId body : {above, below})
            CHECK(std::fabs((turn.inverse() * world.body(body).position()).y() - 0.3) < 5e-3);
    }
}

TEST_CASE("a player walks over the seams of one-way tiles without falling through", "[dynamics][one way]") {
    for (const double speed : {0.3, 1.0, 3.0, 10.0}) {
        for (const ShapeDef& shape : players()) {
            World world;
            ShapeDef tile = oneWay(plumb::box({0.5, 0.1}));
            tile.shape = boxPolygon({0.5, 0.1}, {0, -0.1});
            for (int i = 0; i < 40; ++i)
                world.add({.type = BodyType::Static, .position = {i * 1.0, 0}, .shapes = {tile}});
            BodyDef walker{.position = {0, 0.5}, .fixedRotation = true, .shapes = {shape}};
            const BodyId player = world.add(walker);
            for (int tick = 0; world.body(player).position().x() < 38 && tick < 2000; ++tick) {
                world.body(player).setVelocity({speed, world.body(player).velocity().y()});
                world.step(dt);
                REQUIRE(world.body(player).position().y() > 0.5 - 5e-3);
            }
            CHECK(world.body(player).position().x() > 8);
        }
    }
}

TEST_CASE("a bullet at 300 m/s stops at a platform from above and passes from below", "[dynamics][one way]") {
    for (const int lanes : {1, 4, 8, 16}) {
        for (const ShapeDef& platform : platforms()) {
            for (const double turn : {0.0, 0.7}) {
                World world({.gravity = {0, 0}, .solver = {.lanes = lanes}});
                world.add({.type = BodyType::Static, .shapes = {platform}});
                const ShapeDef bullet = plumb::box({0.05, 0.02});
                const BodyId down =
                    world.add({.position = {-2, 12}, .angle = turn, .velocity = {0, -300}, .shapes = {bullet}});
                const BodyId up =
                    world.add({.position = {2, -12}, .angle = turn, .velocity = {0, 300}, .shapes = {bullet}});
                steps(world, 30);
                CHECK(world.body(down).position().y() > 0);
                CHECK(std::fabs(world.body(up).position().y() - (-12 + 300 * 0.5)) < 1e-9);
            }
        }
    }
}

TEST_CASE("a ball at e = 0.8 thrown up through a platform passes as if it were not there, and then bounces on it",
          "[dynamics][one way]") {
    for (const int lanes : {1, 4, 8, 16}) {
        for (const ShapeDef& platform : platforms()) {
            World world({.solver = {.lanes = lanes}});
            world.add({.type = BodyType::Static, .shapes = {platform}});
            world.add({.position = {0, -1.5}, .velocity = {0, 8}, .shapes = {circle(0.5, {.restitution = 0.8})}});
            const double apex = -2 + 64 / (2 * g);  // of its lowest point
            std::vector<double> approach;
            for (int tick = 0; tick < 150; ++tick) {
                world.step(dt);
                for (const ContactBegin& begin : world.contactBegins()) approach.push_back(begin.approachSpeed);
            }
            REQUIRE(approach.size() >= 2);
            CHECK(std::fabs(approach[0] - std::sqrt(2 * g * apex)) < 1e-9);
            CHECK(std::fabs(approach[1] - 0.8 * approach[0]) < 1e-9);
        }
    }
}

TEST_CASE("a ball that bounces between floor and ceiling passes a platform upwards in the very step of its bounce",
          "[dynamics][one way]") {
    World world({.gravity = {0, 0}});
    const Material elastic{.friction = 0, .restitution = 1};
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {segment({-5, 0}, {5, 0}, elastic)}});
    world.add({.type = BodyType::Static, .shapes = {oneWay(segment({-5, 0}, {5, 0}, elastic))}});
    const BodyId ball = world.add({.position = {0, -0.5}, .velocity = {0, -120}, .shapes = {circle(0.1, elastic)}});
    world.step(dt);  // 0.4 m down to the floor, then up: 1.6 m
    CHECK(std::fabs(world.body(ball).position().y() - (-0.9 + 1.6)) < 1e-9);
    steps(world, 10);
    CHECK(std::fabs(world.body(ball).position().y() - (0.7 + 20)) < 1e-9);
}

TEST_CASE("a rule is asked once as two come near, with what it may go by, and its answer holds until they part",
          "[dynamics][one way]") {
    static int asked;
    static ContactCandidate last;
    asked = 0;
    ShapeDef floor = segment({-5, 0}, {5, 0});
    floor.tag = 7;
    floor.rule = [](const ContactCandidate& question) {
        ++asked;
        last = question;
        return question.otherTag != 13;
    };
    World world;
    world.add({.type = BodyType::Static, .angle = 0.25, .shapes = {floor}});
    ShapeDef ball = circle(0.5), ghost = ball;
    ball.tag = 12;
    ghost.tag = 13;
    const BodyId held = world.add({.position = {0, 3}, .shapes = {ball}});
    for (int tick = 0; tick < 60; ++tick) world.step(dt);
    CHECK(asked == 1);
    CHECK(last.tag == 7);
    CHECK(last.otherTag == 12);
    CHECK((last.localNormal - Vec2(0, 1)).norm() < 1e-6);
    CHECK((last.normal - Rot::fromAngle(0.25) * Vec2(0, 1)).norm() < 1e-6);
    CHECK(last.velocity.y() < -6);
    CHECK(world.body(held).velocity().norm() < 6);
    const BodyId through = world.add({.position = {0, 3}, .shapes = {ghost}});
    world.remove(held);
    for (int tick = 0; tick < 120; ++tick) world.step(dt);
    CHECK(asked == 2);
    CHECK(std::fabs(world.body(through).position().y() - (3 - 0.5 * g * 4)) < 1e-9);
}

TEST_CASE("two shapes touch only if the rules of both say so", "[dynamics][one way]") {
    const ContactRule yes = [](const ContactCandidate&) { return true; };
    const ContactRule no = [](const ContactCandidate&) { return false; };
    for (int both = 0; both < 4; ++both) {
        World world;
        ShapeDef floor = segment({-5, 0}, {5, 0}), ball = circle(0.5);
        floor.rule = (both & 1) != 0 ? yes : no;
        ball.rule = (both & 2) != 0 ? yes : no;
        world.add({.type = BodyType::Static, .shapes = {floor}});
        const BodyId id = world.add({.position = {0, 1}, .shapes = {ball}});
        steps(world, 60);
        CHECK((world.body(id).position().y() > 0) == (both == 3));
    }
}

TEST_CASE("a hundred balls thrown through and onto one-way platforms have the same bits for 1, 4, 8 and 16 lanes",
          "[dynamics][one way]") {
    std::vector<std::uint64_t> hashes;
    for (const int lanes : {1, 4, 8, 16}) {
        World world({.solver = {.lanes = lanes}});
        const Material bouncy{.restitution = 0.5};
        for (int i = 0; i < 3; ++i)
            for (const ShapeDef& platform : platforms(bouncy))
                world.add({.type = BodyType::Static, .position = {3.0 * i, 2.0 * i}, .shapes = {platform}});
        for (int i = 0; i < 100; ++i) {
            const ShapeDef player = players(i % 2 == 0 ? bouncy : Material{})[static_cast<std::size_t>(i % 3)];
            world.add({.position = {-4 + 0.13 * i, -3.0 - i % 7},
                       .velocity = {0.5 * (i % 5) - 1, 8.0 + i % 6},
                       .shapes = {player}});
        }
        steps(world, 300);
        hashes.push_back(stateHash(world));
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
}
