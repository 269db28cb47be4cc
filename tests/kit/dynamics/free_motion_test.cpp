// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/plumb.h>
#include "catch.h"

using namespace plumb;

namespace {

/// The largest distance of a thrown ball from its closed form over two seconds.
double throwError(double rate, double damping) {
    World world({.gravity = {0, -9.81}});
    const Vec2 start(0, 2), speed(8, 11);
    const BodyId ball =
        world.add({.position = start, .velocity = speed, .linearDamping = damping, .shapes = {circle(0.1)}});
    double worst = 0;
    for (int tick = 1; tick <= static_cast<int>(2 * rate); ++tick) {
        world.step(1 / rate);
        const long double t = tick / static_cast<long double>(rate);
        long double x = 0, y = 0;
        if (damping == 0) {
            x = start.x() + speed.x() * t;
            y = start.y() + speed.y() * t - 9.81L * t * t / 2;
        } else {
            const long double k = damping, e = -std::expm1(-k * t) / k;
            x = start.x() + speed.x() * e;
            y = start.y() + (speed.y() + 9.81L / k) * e - 9.81L * t / k;
        }
        const Vec2 truth(static_cast<double>(x), static_cast<double>(y));
        worst = std::max(worst, (world.body(ball).position() - truth).norm());
    }
    return worst;
}

/// (x - 1 + e^-x) / x^2, the way of a damped body over its acceleration times the time squared, by its series
/// 1/2 (1 - x/3 (1 - x/4 (1 - ...))): x + expm1(-x) would lose 1e-14 of it at small x, even in an x87's long double.
/// At x < 0.2 twenty terms leave less than 1e-30, and each rounding counts a fifteenth of the one after it.
double wayShare(double x) {
    double inner = 1;
    for (int n = 22; n >= 3; --n) inner = 1 - x / n * inner;
    return inner / 2;
}

}  // namespace

// 120 steps, each rounding a position of some 10 m once or twice: 120 * 2 * 1e-15 m.
TEST_CASE("a thrown ball is where the formula says at every tick, at 60 Hz and at 20 Hz", "[dynamics][law]") {
    CHECK(throwError(60, 0) < 1e-12);
    CHECK(throwError(20, 0) < 1e-12);
    CHECK(throwError(7, 0) < 1e-12);
}

TEST_CASE("a ball slowed by linear damping is where the formula says, damping 0.2 and 3 per second",
          "[dynamics][law]") {
    CHECK(throwError(60, 0.2) < 1e-12);
    CHECK(throwError(20, 0.2) < 1e-12);
    CHECK(throwError(60, 3) < 1e-12);
    CHECK(throwError(60, 1e-3) < 1e-12);
}

TEST_CASE("a damped body under great acceleration comes as far in a step as the formula says, to rounding",
          "[dynamics][law]") {
    for (const double damping : {1e-3, 0.1, 1.0, 2.0, 2.99, 3.01, 10.0}) {
        World world({.gravity = {0, -1e6}});
        const BodyId body = world.add({.linearDamping = damping, .shapes = {circle(0.1)}});
        world.step(1.0 / 60);
        const double step = 1.0 / 60;
        const double way = -1e6 * step * step * wayShare(damping * step);
        INFO("damping " << damping);
        CHECK(std::fabs(world.body(body).position().y() / way - 1) < 3e-15);
    }
}

TEST_CASE("a free body turns at 2 rad/s through whole turns and keeps counting", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    const BodyId body = world.add({.angularVelocity = 2, .shapes = {box({1, 0.5})}});
    for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.body(body).angle() - 20) < 1e-12);
    CHECK(std::fabs(world.body(body).pose().rotation.sin - std::sin(20.0)) < 1e-12);
}

TEST_CASE("a force of 3 N on 2 kg over one second gives 1.5 m/s and 0.75 m, and then no more", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    const BodyId body = world.add({.mass = Mass{2, {0, 0}, 1}, .shapes = {circle(0.5)}});
    for (int tick = 0; tick < 60; ++tick) {
        world.body(body).applyForce({3, 0});
        world.step(1.0 / 60);
    }
    CHECK(std::fabs(world.body(body).velocity().x() - 1.5) < 1e-12);
    CHECK(std::fabs(world.body(body).position().x() - 0.75) < 1e-12);
    world.step(1.0);
    CHECK(std::fabs(world.body(body).velocity().x() - 1.5) < 1e-12);
}

TEST_CASE("a body passing a wall at one millimetre without touching it stays on its closed form", "[dynamics][law]") {
    World world({.gravity = {0, 0}});
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    const BodyId ball = world.add({.position = {-5, 0.501}, .velocity = {7, 0}, .shapes = {circle(0.5)}});
    for (int tick = 0; tick < 60; ++tick) world.step(1.0 / 60);
    CHECK(world.body(ball).velocity() == Vec2(7, 0));
    CHECK(std::fabs(world.body(ball).position().x() - 2) < 1e-12);
}
