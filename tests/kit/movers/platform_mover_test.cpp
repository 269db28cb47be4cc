// SPDX-License-Identifier: MIT
#include <plumb/movers/platform_mover.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "catch.h"
#include "kit/movers/stage.h"
#include "numbers.h"

namespace plumb::test {

namespace {

constexpr PlatformInput right{.move = 1}, jump{.jump = true};

/// A character of 0.8 m by 1.8 m on a floor from x = -20 to 20 whose top is at y = 0.
struct Game {
    World world;
    PlatformMover mover;

    explicit Game(const PlatformProfile& profile = modernProfile(), double x = 0)
        : mover((addStatic(world, {0, -0.5}, box({20, 0.5})), addKinematic(world, {x, 0.95}, box({0.4, 0.9}))),
                profile) {
        while (!mover.slide().isOnFloor) step(still);
    }
    const Slide& step(const PlatformInput& input, double tick = dt) {
        mover.step(world, input, tick);
        world.step(tick);
        return mover.slide();
    }
    Vec2 position() const { return world.body(mover.body()).position(); }
    /// The highest that it comes in a second.
    double highest(const PlatformInput& input, double tick = dt) {
        double top = position().y();
        for (int i = 0; i * tick < 1; ++i) top = std::max(top, step(input, tick).position.y());
        return top;
    }
};

PlatformProfile with(double coyote, double buffer) {
    PlatformProfile profile = modernProfile();
    profile.vertical.coyoteTime = coyote;
    profile.vertical.jumpBuffer = buffer;
    return profile;
}

}  // namespace

TEST_CASE("a jump is 2.5 m high at 30, 60, 120 and 240 Hz, and at its apex after 0.4 s", "[movers]") {
    for (double share : {1.0, 0.5, 0.3}) {
        for (double hz : {30.0, 60.0, 120.0, 240.0}) {
            Game game(modernProfile({.hangShare = share}));
            const double ground = game.position().y();
            for (int i = 0; i < 0.4 * hz - 0.5; ++i) game.step(jump, 1 / hz);
            // Some hundred roundings of 3 m.
            CHECK(std::fabs(game.position().y() - ground - 2.5) < 1e-13);
            CHECK(std::fabs(game.mover.slide().velocity.y()) < 1e-12);
        }
    }
}

TEST_CASE("a whole jump with a run-up and a turn is the same at 60 and 240 Hz, at each sixtieth of a second",
          "[movers]") {
    Game slow, fast;
    for (int i = 0; i < 90; ++i) {
        const PlatformInput input{.move = i < 40 ? 1.0 : -0.7, .run = i<20, .jump = i> 10 && i < 22};
        slow.step(input);
        for (int k = 0; k < 4; ++k) fast.step(input, dt / 4);
        // It lands within a tick, at most one of the slow ones apart: compared in the air.
        if (slow.mover.slide().isOnFloor || fast.mover.slide().isOnFloor) continue;
        CHECK((slow.position() - fast.position()).cwiseAbs().maxCoeff() < 1e-12);
    }
    CHECK(slow.mover.slide().isOnFloor);
}

TEST_CASE("a jump let go early is lower, the earlier the lower, by its closed form", "[movers]") {
    const JumpBand band = modernProfile({.hangShare = 1}).vertical.jumps[0];
    for (int held = 1; held < 24; ++held) {
        Game game(modernProfile({.hangShare = 1}));
        const double ground = game.position().y();
        double top = ground;
        for (int i = 0; i < 40; ++i) top = std::max(top, game.step({.jump = i < held}).position.y());
        const double t = held * dt, speed = band.takeOffSpeed - band.riseGravity * t;
        const double height = t * (band.takeOffSpeed + speed) / 2 + speed * speed / (2 * band.releaseGravity);
        // The highest of whole ticks: less by at most half a tick's fall from the apex, at either gravity.
        const double missed = std::max(band.releaseGravity, band.fallGravity) * dt * dt / 2;
        CHECK(top - ground <= height + 1e-12);
        CHECK(top - ground >= height - missed);
    }
}

TEST_CASE("it falls at most at its terminal speed of 20 m/s", "[movers]") {
    Game game;
    game.world.body(game.mover.body()).setPose({40, 100}, 0);
    double fastest = 0;
    for (int i = 0; i < 180; ++i) fastest = std::min(fastest, game.step(still).velocity.y());
    CHECK(fastest == -20);
}

TEST_CASE("a spring of 12 m/s lifts off the floor it is set on, as high as its closed form", "[movers]") {
    for (double speed : {12.0, 3.0}) {
        Game game;
        const double ground = game.position().y(), gravity = game.mover.profile().vertical.jumps[0].releaseGravity;
        game.mover.setVelocity({0, speed});
        const double top = game.highest(still) - ground, height = speed * speed / (2 * gravity);
        // The highest of whole ticks: at most half a tick's rise or fall from the apex is missed.
        CHECK(top <= height + 1e-12);
        CHECK(top >= height - gravity * dt * dt / 2);
        CHECK(game.mover.slide().isOnFloor);
        CHECK_FALSE(game.mover.hasJumped());
    }
}

TEST_CASE("a launch rises by its closed form whether jump is held, let go or pressed on the way", "[movers]") {
    for (const bool arcade : {false, true}) {
        const PlatformProfile profile = arcade ? profile1985() : modernProfile();
        const double gravity = profile.vertical.jumps[0].riseGravity, speed = 9, tick = arcade ? tickOf1985 : dt;
        // Those tables move by the speed before each tick: half a tick's way more than the parabola.
        const double height = speed * speed / (2 * gravity) + (arcade ? speed * tick / 2 : 0);
        for (const auto& [pressed, released] : {std::pair(99, 99), {0, 99}, {0, 3}, {6, 99}}) {
            CAPTURE(arcade, pressed, released);
            Game game(profile);
            const double ground = game.position().y();
            game.mover.launch({0, speed});
            double top = ground;
            for (int i = 0; i < 20; ++i) {
                top = std::max(top, game.step({.jump = i >= pressed && i < released}, tick).position.y());
                CHECK_FALSE(game.mover.hasJumped());
            }
            // The highest of whole ticks misses the apex by at most a tick's fall from it.
            CHECK(std::fabs(top - ground - height) <= gravity * tick * tick / 2);
        }
    }
}

TEST_CASE("who is launched at 0.1 m/s and lands in the same tick jumps in the next", "[movers]") {
    Game game;
    game.mover.launch({0, 0.1});
    REQUIRE(game.step(still).isOnFloor);
    game.step(jump);
    CHECK(game.mover.hasJumped());
}

TEST_CASE("who was launched and has landed jumps again, and a blow ends a launch", "[movers]") {
    Game game;
    game.mover.launch({0, 5});
    while (game.step(still).velocity.y() > 0) continue;
    while (!game.mover.slide().isOnFloor) game.step(still);
    game.step(jump);
    CHECK(game.mover.hasJumped());
    Game other;
    const double ground = other.position().y(), gravity = other.mover.profile().vertical.jumps[0].releaseGravity;
    other.mover.launch({0, 9});
    other.mover.setVelocity({0, 9});
    CHECK(other.highest(still) - ground <= 9 * 9 / (2 * gravity) + 1e-12);
}

TEST_CASE("a glider whose terminal speed of 1 m/s is below its hang speed falls no faster", "[movers]") {
    PlatformProfile profile = modernProfile();
    profile.vertical.terminalSpeed = 1;
    profile.vertical.hangSpeed = 2;
    for (double tick : {0.1, dt}) {
        World world;
        PlatformMover mover(addKinematic(world, {0, 100}, circle(0.4)), profile);
        for (int i = 0; i < 120; ++i) {
            const Slide& slide = mover.step(world, {.jump = true}, tick);
            world.step(tick);
            REQUIRE(slide.velocity.y() >= -1);
            REQUIRE(slide.displacement.y() >= -tick * (1 + 1e-12));
        }
        CHECK(mover.slide().velocity.y() == -1);
    }
}

TEST_CASE("who is too fast loses 60 m/s a second by friction in whole ticks and exact ones", "[movers]") {
    for (TickOrder order : {TickOrder::Exact, TickOrder::PositionFirst, TickOrder::VelocityFirst}) {
        PlatformProfile profile = modernProfile();
        profile.horizontal.order = order;
        Game game(profile, -15);
        for (int i = 0; i < 60; ++i) game.step({.move = 1, .run = true});
        for (int i = 1; i <= 2; ++i) CHECK(std::fabs(game.step(right).velocity.x() - (7 - 60 * dt * i)) < 1e-12);
    }
}

TEST_CASE("0.1 s after it ran off a ledge it may still jump, without coyote time, or later, not", "[movers]") {
    const auto jumpsAfter = [](double coyote, int ticks) {
        Game game(with(coyote, 0), 19);
        while (game.step(right).isOnFloor) {
        }
        for (int i = 1; i < ticks; ++i) game.step(right);
        game.step({.move = 1, .jump = true});
        return game.mover.hasJumped() && game.mover.slide().velocity.y() > 5;
    };
    CHECK(jumpsAfter(0.1, 1));
    CHECK(jumpsAfter(0.1, 6));
    CHECK_FALSE(jumpsAfter(0.1, 7));
    CHECK_FALSE(jumpsAfter(0, 1));
}

TEST_CASE("who jumped does not jump again in the air within the coyote time", "[movers]") {
    Game game(with(0.5, 0));
    game.step(jump);
    game.step(still);
    game.step(jump);
    CHECK_FALSE(game.mover.hasJumped());
}

TEST_CASE("a jump asked for 0.1 s before landing is made on landing, without a buffer, or earlier, not", "[movers]") {
    const auto jumpsWhenAskedBefore = [](double buffer, int ticks) {
        Game game(with(0, buffer));
        game.step(jump);
        int air = 1;
        while (!game.step(still).isOnFloor) ++air;
        Game again(with(0, buffer));
        again.step(jump);
        for (int i = 1; i < air + 1 - ticks; ++i) again.step(still);
        bool jumped = false;
        for (int i = 0; i < ticks + 3; ++i) {
            again.step(jump);
            jumped |= again.mover.hasJumped();
        }
        return jumped;
    };
    CHECK(jumpsWhenAskedBefore(0.1, 2));
    CHECK(jumpsWhenAskedBefore(0.1, 5));
    CHECK_FALSE(jumpsWhenAskedBefore(0.1, 9));
    CHECK_FALSE(jumpsWhenAskedBefore(0, 2));
}

TEST_CASE("jumping under an edge by 0.2 m it is shifted aside and rises, without corner correction it bumps",
          "[movers]") {
    for (double side : {1.0, -1.0}) {
        PlatformProfile plain = modernProfile();
        plain.slide.cornerCorrection = 0;
        for (const PlatformProfile& profile : {modernProfile(), plain}) {
            Game game(profile);
            addStatic(game.world, {side * 1.2, 3}, box({1, 0.5}));  // its edge is 0.2 m from the middle
            const double top = game.highest(jump);
            if (profile.slide.cornerCorrection > 0) {
                CHECK(top > 0.9 + 2.4);
                // A skin around a corner is round: its last thousandth is that flat.
                CHECK(std::fabs(game.position().x() + side * (0.2 + 1e-3)) < 1e-6);
            } else {
                CHECK(std::fabs(top - (2.5 - 0.9 - 1e-3)) < 1e-9);
                CHECK(game.position().x() == 0);
            }
        }
        Game deep;
        addStatic(deep.world, {side * 1.1, 3}, box({1, 0.5}));  // 0.3 m are too much
        CHECK(deep.highest(jump) < 0.9 + 1);
    }
}

TEST_CASE("a ledge 0.08 m too high for a jump is taken with the nudge, and not without", "[movers]") {
    for (double nudge : {0.1, 0.0}) {
        PlatformProfile profile = modernProfile();
        profile.slide.ledgeNudge = nudge;
        Game game(profile, -1);
        // The feet come to 2.5 m and a skin at the most.
        addStatic(game.world, {2, 0}, {.shape = boxPolygon({2, 2.58})});
        for (int i = 0; i < 90; ++i) game.step({.move = 1, .jump = i < 40});
        CHECK((game.position().y() > 3) == (nudge > 0));
    }
}

TEST_CASE("down and jump on a one-way floor drops through it, on another it jumps", "[movers]") {
    for (bool oneWay : {true, false}) {
        for (double hz : {60.0, 240.0}) {
            Game game;
            ShapeDef slab = box({2, 0.1});
            if (oneWay) slab.oneWay = Vec2(0, 1);
            addStatic(game.world, {0, 3}, slab);
            game.world.body(game.mover.body()).setPose({0, 4.05}, 0);
            for (int i = 0; i < 30; ++i) game.step(still, 1 / hz);
            REQUIRE(game.mover.slide().isOnFloor);
            game.step({.jump = true, .down = true}, 1 / hz);
            CHECK(game.mover.hasJumped() != oneWay);
            for (int i = 0; i < hz; ++i) game.step(still, 1 / hz);
            CHECK(game.mover.slide().isOnFloor);
            CHECK((game.position().y() < 1) == oneWay);
        }
    }
}

TEST_CASE("under a low ceiling it bumps, says so, and falls", "[movers]") {
    Game game;
    addStatic(game.world, {0, 3}, box({3, 0.5}));
    bool bumped = false;
    for (int i = 0; i < 30 && !bumped; ++i) bumped = game.step(jump).isOnCeiling;
    CHECK(bumped);
    CHECK(game.mover.slide().velocity.y() == 0);
    CHECK(std::fabs(game.position().y() - (2.5 - 0.9 - 1e-3)) < 1e-9);
}

TEST_CASE("at a wall it stops, says so with the wall's normal, and starts anew from 0", "[movers]") {
    Game game;
    addStatic(game.world, {3, 1}, box({0.5, 1}));
    for (int i = 0; i < 60; ++i) game.step(right);
    CHECK(game.mover.slide().isOnWall);
    CHECK(game.mover.slide().isOnFloor);
    CHECK(game.mover.slide().wallNormal == Vec2(-1, 0));
    CHECK(game.mover.slide().velocity.x() == 0);
    game.step({.move = -1});
    CHECK_FALSE(game.mover.slide().isOnWall);
    CHECK(game.mover.slide().velocity.x() < 0);
}

TEST_CASE("a copy of mover and world goes on to the same bits", "[movers]") {
    Game game;
    for (int i = 0; i < 30; ++i) game.step({.move = 1, .run = true, .jump = i > 20});
    World world = game.world;
    PlatformMover mover = game.mover;
    for (int i = 0; i < 100; ++i) {
        const PlatformInput input{.move = -1, .jump = i % 40 == 39};
        game.step(input);
        mover.step(world, input, dt);
        world.step(dt);
        REQUIRE(world.body(mover.body()).position() == game.position());
    }
}

TEST_CASE("profiles and input out of range are refused, by name", "[movers]") {
    const auto complaint = [](const PlatformProfile& profile, const PlatformInput& input, double tick) {
        try {
            World world;
            PlatformMover mover(addKinematic(world, {0, 0}, circle(1)), profile);
            mover.step(world, input, tick);
        } catch (const std::invalid_argument& refused) {
            return std::string(refused.what());
        }
        return std::string("nothing");
    };
    const auto changed = [](auto&& change) {
        PlatformProfile profile = modernProfile();
        change(profile);
        return profile;
    };
    CHECK(complaint(modernProfile(), right, dt) == "nothing");
    CHECK_THAT(complaint(modernProfile(), {.move = 1.5}, dt), containsText("PlatformInput.move"));
    CHECK_THAT(complaint(modernProfile(), right, 0), containsText("dt"));
    CHECK_THAT(complaint(changed([](auto& p) { p.horizontal.runSpeed = -1; }), right, dt),
               containsText("horizontal.runSpeed"));
    CHECK_THAT(complaint(changed([](auto& p) { p.vertical.jumps.clear(); }), right, dt),
               containsText("vertical.jumps"));
    CHECK_THAT(complaint(changed([](auto& p) { p.vertical.jumps[0].fromSpeed = 1; }), right, dt),
               containsText("vertical.jumps[0].fromSpeed"));
    CHECK_THAT(complaint(changed([](auto& p) { p.vertical.terminalSpeed = 0; }), right, dt),
               containsText("terminalSpeed"));
    CHECK_THAT(complaint(changed([](auto& p) { p.vertical.hangShare = nan; }), right, dt), containsText("hangShare"));
    CHECK_THAT(complaint(changed([](auto& p) { p.slide.skin = -1; }), right, dt), containsText("slide.skin"));
    CHECK_THAT(complaint(changed([](auto& p) { p.grain = -1; }), right, dt), containsText("grain"));
    CHECK_THROWS_AS(modernProfile({.height = 0}), std::invalid_argument);
    CHECK_THROWS_AS(modernProfile({.hangSpeedPart = 2}), std::invalid_argument);
}

}  // namespace plumb::test
