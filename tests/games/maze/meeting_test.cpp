// SPDX-License-Identifier: MIT
// Source of all rules: The Pac-Man Dossier. Source of the 60 frames and of the start positions: a clone of the game.
#include <games/maze/chase.h>

#include <algorithm>

#include <games/maze/lanes.h>
#include <plumb/math/random.h>

#include "catch.h"
#include "games/maze/driven.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

/// The position of a pixel of the arcade's screen, counted from its upper left corner [tiles].
Vec2 placeOf(int x, int y) {
    return Vec2(x / 8.0, (288 - y) / 8.0);
}

bool isEyes(const Hunter& hunter) {
    return hunter.where() == Where::Eyes || hunter.where() == Where::Entering;
}

}  // namespace

TEST_CASE("the four hunters start at the source's pixels, the chaser before the door", "[games][maze]") {
    const Chase chase(1);
    CHECK(chase.hunter(Who::Chaser).position() == placeOf(112, 116));
    CHECK(chase.hunter(Who::Ambusher).position() == placeOf(112, 140));
    CHECK(chase.hunter(Who::Flanker).position() == placeOf(96, 140));
    CHECK(chase.hunter(Who::Loner).position() == placeOf(128, 140));
}

TEST_CASE("a hunter and the player meet if both are in one cell after both moved, if they swap cells, they pass",
          "[games][maze]") {
    int caught = 0, swapped = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        Chase chase(static_cast<int>(seed % 21) + 1, seed);
        Direction wanted = Direction::Left;
        for (int frame = 0; frame < 3'000; ++frame) {
            if (chase.playerCaught()) chase.beginLifeAfterDeath();
            if (random.integer(0, 9) == 0) wanted = static_cast<Direction>(random.integer(0, 3));
            const bool frozen = chase.frozen();
            const Cell player = chase.player().cell();
            const auto before = chase.hunters();
            chase.step(wanted);
            if (frozen) continue;
            int danger = 0, prey = 0, passing = 0;
            for (const Who who : everyone) {
                const Hunter &was = before[indexOf(who)], &now = chase.hunter(who);
                const bool meets = was.canMeet() && now.cell() == chase.player().cell();
                danger += meets && now.canMeet() && !now.frightened() ? 1 : 0;
                prey += meets && now.where() == Where::Eyes ? 1 : 0;
                passing += was.canMeet() && !(player == chase.player().cell()) && now.cell() == player &&
                           was.cell() == chase.player().cell();
            }
            CAPTURE(seed, frame);
            if (chase.frozen()) REQUIRE(prey == 1);
            if (!chase.frozen()) REQUIRE(chase.playerCaught() == (danger > 0));
            caught += chase.playerCaught() ? 1 : 0;
            swapped += passing > 0 && !chase.playerCaught() ? 1 : 0;
        }
    }
    CHECK(caught > 100);
    CHECK(swapped > 0);
}

TEST_CASE("in one fright hunters give 200, 400, 800, 1600 points, after each, only eyes move for 60 frames",
          "[games][maze]") {
    test::DrivenChase driven(1, 1, {.frames = 120, .hunter = 4000});
    const Chase& chase = driven.chase();
    int next = 200, most = 0, stood = 0, ran = 0;
    for (int frame = 0; frame < 8'000; ++frame) {
        const bool frozen = chase.frozen();
        const auto before = chase.hunters();
        const Vec2 place = chase.playerPosition();
        const std::optional<Who> last = chase.justCaught();
        driven.step();
        if (frozen) {
            REQUIRE(chase.playerPosition() == place);
            for (const Hunter& hunter : chase.hunters()) {
                const bool runs = isEyes(before[indexOf(hunter.who())]) && hunter.who() != last;
                const bool moved = hunter.position() != before[indexOf(hunter.who())].position();
                if (!runs && chase.frozen()) REQUIRE_FALSE(moved);
                ran += runs && moved ? 1 : 0;
            }
            ++stood;
            if (!chase.frozen()) REQUIRE(std::exchange(stood, 0) == 60);
        }
        for (const ChaseEvent& event : chase.events()) {
            if (event.kind == Happening::Power) next = 200;
            if (event.kind != Happening::HunterCaught) continue;
            REQUIRE(event.points == next);
            most = std::max(most, event.points);
            next *= 2;
        }
    }
    CHECK(most == 1600);
    CHECK(ran > 100);
}

TEST_CASE("a new life begins at the start positions, with the dots that are left and new waves", "[games][maze]") {
    Chase chase(1);
    for (int frame = 0; frame < 5'000 && !chase.playerCaught(); ++frame) chase.step(std::nullopt);
    REQUIRE(chase.playerCaught());
    CHECK(chase.framesOfWaves() > 0);
    const int dots = chase.dotsLeft();
    CHECK(dots < 244);
    chase.beginLifeAfterDeath();
    const Chase fresh(1);
    CHECK(chase.dotsLeft() == dots);
    CHECK(chase.framesOfWaves() == 0);
    CHECK(chase.counters().countsForAll());
    CHECK_FALSE(chase.playerCaught());
    CHECK(chase.playerPosition() == fresh.playerPosition());
    for (const Who who : everyone) CHECK(chase.hunter(who).position() == fresh.hunter(who).position());
}

TEST_CASE("a caught hunter becomes eyes, runs home at 2 pixels a frame, and is in the lanes again within 6 s",
          "[games][maze]") {
    test::DrivenChase driven(1, 2, {.frames = 120, .hunter = 4000});
    const Chase& chase = driven.chase();
    std::array<int, 4> away{};
    int back = 0, longest = 0;
    for (int frame = 0; frame < 8'000; ++frame) {
        const bool frozen = chase.frozen();
        const auto before = chase.hunters();
        if (chase.playerCaught() || chase.cleared()) away = {};
        driven.step();
        for (const Hunter& hunter : chase.hunters()) {
            int& frames = away[indexOf(hunter.who())];
            const Hunter& was = before[indexOf(hunter.who())];
            const bool runs = was.where() == Where::Eyes && hunter.where() == Where::Eyes;
            const Vec2 way = 8 * (hunter.position() - was.position()).cwiseAbs();
            if (runs && !frozen && way.x() < 100) REQUIRE(way.sum() == 2);
            if (isEyes(hunter)) REQUIRE_FALSE(hunter.frightened());
            if (hunter.where() == Where::Eyes && frames == 0) frames = 1;
            if (frames == 0) continue;
            frames += frozen ? 0 : 1;
            if (hunter.where() != Where::Lanes) continue;
            longest = std::max(longest, std::exchange(frames, 0));
            ++back;
        }
    }
    CHECK(back > 10);
    CHECK(longest < 6 * 60);
}

TEST_CASE("a player that is caught during a fright begins the next life without fright and without fruit",
          "[games][maze]") {
    test::DrivenChase driven(1, 1, {.frames = 120, .hunter = 4000});
    const Lookahead weary({.frames = 80, .dot = 0, .hunter = -1000, .nearness = -200, .caught = -50'000});
    int afraid = 0;
    for (int frame = 0; frame < 4'000 && afraid == 0; ++frame) {
        driven.step();
        const auto& hunters = driven.chase().hunters();
        const bool brave = std::any_of(hunters.begin(), hunters.end(), [](const Hunter& hunter) {
            return hunter.where() == Where::Leaving && !hunter.frightened();
        });
        if (driven.chase().frightFrames() < 120 || !brave || frame % 8 != 0) continue;
        Chase chase = driven.chase();
        while (chase.frightFrames() > 0 && !chase.playerCaught()) chase.step(weary.best(chase));
        if (!chase.playerCaught()) continue;
        ++afraid;
        chase.beginLifeAfterDeath();
        CHECK(chase.frightFrames() == 0);
        CHECK_FALSE(chase.fruitShown());
        for (const Hunter& hunter : chase.hunters()) CHECK_FALSE(hunter.frightened());
    }
    CHECK(afraid == 1);
}

TEST_CASE("random numbers are the same in each life of a level, whatever the life before used", "[games][maze]") {
    Chase chase(1, 7), other(1, 7);
    other.reseed(99);
    for (int frame = 0; frame < 5'000 && !chase.playerCaught(); ++frame) {
        chase.step(std::nullopt);
        other.step(std::nullopt);
    }
    const auto hashOf = [](const Chase& one) {
        games::Hash hash;
        one.addTo(hash);
        return hash.value();
    };
    REQUIRE(chase.playerCaught());
    CHECK(hashOf(chase) != hashOf(other));
    chase.beginLifeAfterDeath();
    other.beginLifeAfterDeath();
    CHECK(hashOf(chase) == hashOf(other));
}

TEST_CASE("after a death the chaser has no haste until the loner leaves the house, even if few dots are left",
          "[games][maze]") {
    test::DrivenChase driven(1);
    for (int frame = 0; frame < 10'000 && driven.chase().dotsLeft() > 10; ++frame) driven.step();
    Chase chase = driven.chase();
    CHECK(chase.haste() == 2);
    for (int frame = 0; frame < 5'000 && !chase.playerCaught(); ++frame) chase.step(std::nullopt);
    REQUIRE(chase.playerCaught());
    chase.beginLifeAfterDeath();
    const Lookahead shy({.frames = 80, .dot = -1000, .way = 0});  // eats nothing: the house waits 4 s for each
    int waited = 0;
    for (; chase.hunter(Who::Loner).where() == Where::Home && waited < 1'000; ++waited) {
        REQUIRE(chase.haste() == 0);
        chase.step(shy.best(chase));
        REQUIRE_FALSE(chase.playerCaught());
    }
    CHECK(waited == 3 * 240);
    CHECK(chase.haste() == 2);
}

TEST_CASE("in the first life of level 1 the flanker leaves the house at the 30th dot, the loner at the 90th",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    std::array<int, 4> left{-1, -1, -1, -1};
    for (int frame = 0; frame < 3'000 && left[indexOf(Who::Loner)] < 0; ++frame) {
        driven.step();
        for (const Who who : everyone) {
            int& dots = left[indexOf(who)];
            if (dots < 0 && chase.hunter(who).where() != Where::Home) dots = chase.dotsEaten();
        }
    }
    CHECK(left == std::array<int, 4>{0, 0, 30, 90});
}
