// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

World bouncingFloorWorld(double restitution) {
    World world({.gravity = {0, -g}});
    const Material material{.restitution = restitution};
    world.add({.type = BodyType::Static, .shapes = {segment({-50, 0}, {50, 0}, material)}});
    return world;
}

/// The height the body's lowest point would rise to, from its energy now.
double apex(const World& world, BodyId body, double radius) {
    const auto view = world.body(body);
    return view.position().y() - radius + view.velocity().y() * view.velocity().y() / (2 * g);
}

}  // namespace

// Each bounce finds its time to 1e-12 m of height, and rounds a few times: far below the micrometre asked for.
TEST_CASE("a ball dropped from 5 m at e = 1 returns to 5.000000 m twenty times", "[dynamics][law]") {
    World world = bouncingFloorWorld(1);
    const BodyId ball = world.add({.position = {0, 5.5}, .shapes = {circle(0.5)}});
    int bounces = 0;
    for (int tick = 0; bounces < 20; ++tick) {
        REQUIRE(tick < 60 * 60);
        world.step(1.0 / 60);
        CHECK(std::fabs(apex(world, ball, 0.5) - 5) < 1e-9);
        bounces += static_cast<int>(world.contactBegins().size());
    }
}

TEST_CASE("a ball at e = 0.8 loses 36 % of its height at every bounce, and comes to rest", "[dynamics][law]") {
    World world = bouncingFloorWorld(0.8);
    const BodyId ball = world.add({.position = {0, 1.5}, .shapes = {circle(0.5)}});
    double height = 1;
    for (int tick = 0; tick < 60 * 5; ++tick) {
        world.step(1.0 / 60);
        const double flight = 2 * std::sqrt(2 * height / g);
        if (flight > 4.0 / 60 && world.contactBegins().size() == 1) {
            height *= 0.64;
            CHECK(std::fabs(apex(world, ball, 0.5) - height) < 1e-9);
        }
    }
    CHECK(height < 0.01);
    CHECK(std::fabs(world.body(ball).position().y() - 0.5) < 1e-3);
    CHECK_FALSE(world.body(ball).awake());
}

TEST_CASE("a touch at 0.9 m/s at e = 1 leaves the wall at 0.9 m/s", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    world.add({.type = BodyType::Static, .shapes = {segment({0, -5}, {0, 5}, {.restitution = 1})}});
    const BodyId ball = world.add({.position = {-1, 0}, .velocity = {0.9, 0}, .shapes = {circle(0.5)}});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.body(ball).velocity().x() + 0.9) < 1e-12);
    CHECK(std::fabs(world.body(ball).position().x() - (-0.5 - 0.9 * (2 - 0.5 / 0.9))) < 1e-10);
}

TEST_CASE("a wall sends back even 1 mm/s at e = 1", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    world.add({.type = BodyType::Static, .shapes = {segment({0, -5}, {0, 5}, {.restitution = 1})}});
    const BodyId ball = world.add({.position = {-0.501, 0}, .velocity = {0.001, 0}, .shapes = {circle(0.5)}});
    for (int tick = 0; tick < 180; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.body(ball).velocity().x() + 0.001) < 1e-12);
}

TEST_CASE("discs of 2 kg and 1 kg head on at 3 and -1 m/s part as Newton's law says", "[dynamics][law]") {
    struct Case {
        double e, v1, v2;
    };
    // Worked numbers: e = 1: 1/3 and 13/3; e = 0.5: 1 and 3; e = 0: 5/3 both
    for (const Case& c : {Case{1, 1.0 / 3, 13.0 / 3}, Case{0.5, 1, 3}, Case{0, 5.0 / 3, 5.0 / 3}}) {
        World world({.gravity = {0, 0}});
        const Material m{.friction = 0, .restitution = c.e};
        const auto disc = [&](double x, double v, double mass) {
            return world.add(
                {.position = {x, 0}, .velocity = {v, 0}, .mass = Mass{mass, {0, 0}, 1}, .shapes = {circle(0.5, m)}});
        };
        const BodyId a = disc(-2, 3, 2);
        const BodyId b = disc(2, -1, 1);
        for (int tick = 0; tick < 90; ++tick) world.step(1.0 / 60);
        const double rounding = c.e > 0 ? 1e-12 : 1e-6;  // e = 0 goes through the solver's floats
        CHECK(std::fabs(world.body(a).velocity().x() - c.v1) < rounding);
        CHECK(std::fabs(world.body(b).velocity().x() - c.v2) < rounding);
    }
}

TEST_CASE("a disc at 4 m/s lands with slip on a floor: it sticks at mu 0.5 and slips at mu 0.2", "[dynamics][law]") {
    struct Case {
        double friction, vx, omega;
    };
    for (const Case& c : {Case{0.5, 8.0 / 3, -16.0 / 3}, Case{0.2, 3.1, -3.6}}) {
        World world({.gravity = {0, 0}});
        const Material m{.friction = c.friction, .restitution = 0.5};
        world.add({.type = BodyType::Static, .shapes = {segment({-50, 0}, {50, 0}, m)}});
        const BodyId disc = world.add({.position = {0, 1}, .velocity = {4, -3}, .shapes = {circle(0.5, m)}});
        for (int tick = 0; tick < 30; ++tick) world.step(1.0 / 60);
        CHECK(std::fabs(world.body(disc).velocity().x() - c.vx) < 1e-12);
        CHECK(std::fabs(world.body(disc).velocity().y() - 1.5) < 1e-12);
        CHECK(std::fabs(world.body(disc).angularVelocity() - c.omega) < 1e-12);
    }
}

TEST_CASE("a box that lands flat at e = 0.5 leaves flat at half its speed", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    const Material m{.friction = 0.6, .restitution = 0.5};
    world.add({.type = BodyType::Static, .shapes = {segment({-50, 0}, {50, 0}, m)}});
    const BodyId box = world.add({.position = {0, 2}, .velocity = {0, -3}, .shapes = {plumb::box({1, 0.5}, m)}});
    for (int tick = 0; tick < 60; ++tick) world.step(1.0 / 60);
    // the two corners stand where float arithmetic puts them: 1e-7 of a metre of arm
    CHECK(std::fabs(world.body(box).velocity().y() - 1.5) < 1e-6);
    CHECK(std::fabs(world.body(box).angularVelocity()) < 1e-6);
}

TEST_CASE("twenty elastic discs in a box keep their energy to 1e-9 over a minute", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    const Material m{.friction = 0, .restitution = 1};
    const double side = 5;
    world.add({.type = BodyType::Static,
               .shapes = {segment({-side, -side}, {side, -side}, m), segment({side, -side}, {side, side}, m),
                          segment({side, side}, {-side, side}, m), segment({-side, side}, {-side, -side}, m)}});
    Random random(7);
    std::vector<BodyId> discs;
    double before = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec2 velocity(random.uniform(-3, 3), random.uniform(-3, 3));
        before += velocity.squaredNorm();
        discs.push_back(world.add({.position = Vec2(-4.0 + 2 * (i % 5), -3.5 + 2 * (i / 5)),
                                   .velocity = velocity,
                                   .shapes = {circle(0.3, m)}}));
    }
    std::size_t hits = 0;
    for (int tick = 0; tick < 3600; ++tick) {
        world.step(1.0 / 60);
        hits += world.contactBegins().size();
    }
    double after = 0;
    for (const BodyId id : discs) {
        after += world.body(id).velocity().squaredNorm();
        CHECK(world.body(id).position().cwiseAbs().maxCoeff() < side);
    }
    CHECK(hits > 300);
    CHECK(std::fabs(after / before - 1) < 1e-9);
}

// Momentum: (m v + M 0) / (m + M), with m = 0.01 pi and M = 2 kg.
TEST_CASE(
    "a ball that a wall sends back at 30 to 120 m/s onto a plate without bounce does not fly through it in that step",
    "[dynamics][law]") {
    for (const double speed : {30.0, 60.0, 120.0}) {
        World world({.gravity = {0, 0}});
        const Material elastic{.friction = 0, .restitution = 1, .restitutionMix = Mix::Minimum};
        const Material dead{.density = 50, .friction = 0, .restitutionMix = Mix::Minimum};
        world.add({.type = BodyType::Static, .shapes = {segment({0, -5}, {0, 5}, elastic)}});
        const BodyId plate = world.add({.position = {-0.5, 0}, .shapes = {plumb::box({0.01, 1}, dead)}});
        const BodyId ball =
            world.add({.position = {-0.25, 0}, .velocity = {speed, 0}, .shapes = {circle(0.1, elastic)}});
        for (int tick = 0; tick < 4; ++tick) {
            world.step(1.0 / 60);
            CHECK(world.body(ball).position().x() > world.body(plate).position().x() + 0.11 - 1e-3);
        }
        const double together = -speed * world.body(ball).mass() / (world.body(ball).mass() + 2);
        CHECK(std::fabs(world.body(plate).velocity().x() - together) < 1e-5 * speed);
    }
}
