// SPDX-License-Identifier: MIT
#include <games/maze/maze_game.h>

#include <plumb/math/random.h>
#include "cases.h"
#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::maze;

GameSetup setupOf(std::uint64_t seed, const std::string& levels = "0") {
    return {seed, {{"level", "1"}, {"levels", levels}}};
}

/// A game of the computer, up to its end or a number of ticks.
struct Played {
    Outcome outcome;
    std::int64_t score;
    std::uint64_t hash;
    int ticks;
};
Played play(const GameSetup& setup, int most) {
    const GameInfo game = info();
    const ActionList actions = withMenuActions(game.actions);
    const auto round = game.make(setup);
    const auto player = game.computer(setup);
    Buttons before = 0;
    int ticks = 0;
    for (; ticks < most && round->progress().outcome == Outcome::Running; ++ticks) {
        const Buttons now = player->decide(*round);
        round->update(Input(actions, now, before));
        before = now;
    }
    return {round->progress().outcome, round->progress().score, round->hash(), ticks};
}

}  // namespace

TEST_CASE("the computer clears the first level in at least nine of ten games", "[games][maze][slow]") {
    const int games = test::cases(100);
    int won = 0;
    for (int seed = 1; seed <= games; ++seed)
        won += play(setupOf(static_cast<std::uint64_t>(seed), "1"), 30'000).outcome == Outcome::Won;
    CHECK(won >= games * 9 / 10);
}

TEST_CASE("the same seed and buttons give the same bits, another seed gives other bits", "[games][maze]") {
    const Played first = play(setupOf(7), 3000), again = play(setupOf(7), 3000), other = play(setupOf(8), 3000);
    CHECK(first.hash == again.hash);
    CHECK(first.score == again.score);
    CHECK(first.hash != other.hash);
}

TEST_CASE("a copy of a chase runs exactly like the chase, for 5,000 frames of random steering", "[games][maze]") {
    Random random(3);
    Chase chase(1, 5);
    Chase copy = chase;
    for (int frame = 0; frame < 5'000; ++frame) {
        if (chase.playerCaught()) chase.beginLifeAfterDeath();
        if (frame % 500 == 0) copy = chase;
        if (copy.playerCaught()) copy.beginLifeAfterDeath();
        const auto wanted = static_cast<Direction>(random.integer(0, 3));
        chase.step(wanted);
        copy.step(wanted);
        Hash a, b;
        chase.addTo(a);
        copy.addTo(b);
        REQUIRE(a.value() == b.value());
        REQUIRE(isLane(chase.player().cell()));
        for (const Hunter& hunter : chase.hunters()) REQUIRE(isLane(hunter.cell()));
    }
}

TEST_CASE("fruit appears after 70 and 170 dots, stays for 9 to 10 s, and disappears when eaten", "[games][maze]") {
    int shown = 0, gone = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const GameInfo game = info();
        const ActionList actions = withMenuActions(game.actions);
        MazeGame round(setupOf(seed));
        const auto player = game.computer(setupOf(seed));
        int frames = 0;
        for (int tick = 0; tick < 5'000 && round.level() == 1; ++tick) {
            const bool was = round.chase().fruitShown(), plays = round.phase() == Phase::Play;
            const bool frozen = round.chase().frozen();
            round.update(Input(actions, player->decide(round), 0));
            if (!plays) continue;
            for (const ChaseEvent& event : round.chase().events()) {
                if (event.kind == Happening::FruitShown) {
                    const int eaten = 244 - round.chase().dotsLeft();
                    CHECK((eaten == 70 || eaten == 170));
                    ++shown;
                    frames = 0;
                }
                if (event.kind == Happening::Fruit) {
                    CHECK(event.points == 100);
                    CHECK((round.chase().playerPosition() - Vec2(14, 15.5)).norm() <= 0.5);  // below the house
                }
                if (event.kind != Happening::FruitGone) continue;
                ++gone;
                CHECK(frames + 2 >= 9 * 60);  // plus the first and the last frame
                CHECK(frames + 2 <= 10 * 60);
            }
            frames += was && !frozen ? 1 : 0;
        }
    }
    CHECK(shown >= 4);
    CHECK(gone >= 1);
}

TEST_CASE("a remembered tap is part of the hash before anything moves", "[games][maze]") {
    const ActionList actions = withMenuActions(info().actions);
    MazeGame tapped(setupOf(1)), left(setupOf(1));
    tapped.update(Input(actions, 1, 0));
    left.update(Input(actions, 0, 0));
    CHECK(tapped.hash() != left.hash());
}

TEST_CASE("an option that is not a number throws an error with its name", "[games][maze]") {
    CHECK_THROWS_WITH(MazeGame(setupOf(1, "many")), "--levels: \"many\" is not a whole number from 0 to 1000");
    CHECK_THROWS_AS(MazeGame({1, {{"level", "0"}, {"levels", "0"}}}), std::invalid_argument);
}

TEST_CASE("a player that stands still loses three lives, and then the game", "[games][maze]") {
    const GameInfo game = info();
    const ActionList actions = withMenuActions(game.actions);
    MazeGame round(setupOf(1));
    int lives = round.lives(), lost = 0;
    for (int tick = 0; tick < 20'000 && round.progress().outcome == Outcome::Running; ++tick) {
        round.update(Input(actions, 0, 0));
        lost += round.lives() < lives ? 1 : 0;
        lives = round.lives();
    }
    CHECK(lost == 3);
    CHECK(round.verdict() == "Rusty got you");  // the cat that runs after the mouse
    CHECK(round.progress().outcome == Outcome::Lost);
}

// Source: The Pac-Man Dossier, its table of bonus symbols.
TEST_CASE("fruit gives 100, 300, 500, 500, 700, 700, 1000, 1000, 2000, 2000, 3000, 3000, and 5000 from level 13 on",
          "[games][maze]") {
    const std::vector<int> points{100, 300, 500, 500, 700, 700, 1000, 1000, 2000, 2000, 3000, 3000, 5000, 5000, 5000};
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(rulesOf(static_cast<int>(i) + 1).fruit.points == points[i]);
}

TEST_CASE("a level ends with its 244th crumb, and the next begins with 244, 10,000 points give one extra life",
          "[games][maze][slow]") {
    const GameSetup setup{1, {{"level", "13"}, {"levels", "3"}}};
    const GameInfo game = info();
    const ActionList actions = withMenuActions(game.actions);
    MazeGame round(setup);
    const auto player = game.computer(setup);
    Buttons before = 0;
    int gained = 0, levels = 0;
    for (int tick = 0; tick < 40'000 && round.progress().outcome == Outcome::Running; ++tick) {
        const int level = round.level(), lives = round.lives(), left = round.chase().dotsLeft();
        const std::int64_t score = round.score();
        const Buttons now = player->decide(round);
        round.update(Input(actions, now, before));
        before = now;
        CHECK((round.phase() == Phase::Cleared) == (round.chase().dotsLeft() == 0));
        if (round.level() != level) {
            CHECK(left == 0);
            CHECK(round.chase().dotsLeft() == 244);
            ++levels;
        }
        const bool crosses = score < 10'000 && round.score() >= 10'000;
        if (crosses) CHECK(round.lives() == lives + 1);
        if (!crosses) CHECK(round.lives() <= lives);
        gained += crosses ? 1 : 0;
    }
    CHECK(levels == 2);
    CHECK(gained == 1);
    CHECK(round.progress().outcome == Outcome::Won);
}
