// SPDX-License-Identifier: MIT
#include <games/frame/session.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "games/every_game.h"

using namespace plumb;
using namespace plumb::games;

namespace {

/// Presses random buttons and holds them for up to a second.
class Hand {
public:
    Hand(std::uint64_t seed, int actions) : random_(seed), actions_(actions) {}

    Buttons next() {
        if (--left_ <= 0) {
            left_ = random_.integer(1, 60);
            buttons_ = Buttons(random_.bits()) & Buttons(random_.bits()) & Buttons((std::uint64_t{1} << actions_) - 1);
        }
        return buttons_;
    }

private:
    Random random_;
    int actions_;
    int left_ = 0;
    Buttons buttons_ = 0;
};

void requireSound(const Game& game) {
    const World* world = game.world();
    if (world == nullptr) return;
    REQUIRE(world->quarantines().empty());
    for (const BodyId id : world->bodies()) {
        const BodyView body = world->body(id);
        REQUIRE_FALSE(body.quarantined());
        REQUIRE(body.position().allFinite());
    }
}

/// Plays rounds of a game for a number of ticks, each round with another seed. Returns the hash of the session.
std::uint64_t playAtRandom(const GameInfo& info, std::uint64_t seed, int ticks) {
    Session session(info, {.seed = seed});
    const auto own = static_cast<int>(info.actions.size());
    Hand hand(seed, own);
    const Buttons menus = ~Buttons((std::uint64_t{1} << own) - 1);
    Random random(seed);
    for (int tick = 0; tick < ticks; ++tick) {
        // In a menu, confirm starts a round. Now and then a random button of the menus leaves a round or pauses it.
        const bool menu = session.screen() != Screen::Play;
        const Buttons confirm = tick % 2 == 0 ? session.actions().button("confirm") : 0;
        const Buttons stray = random.integer(0, 2000) == 0 ? Buttons(random.bits()) & menus : 0;
        session.update(menu ? confirm : hand.next() | stray);
        session.takeCues();
        if (tick % 100 == 0 && session.game() != nullptr) requireSound(*session.game());
        if (tick % 1000 == 0) {
            Canvas canvas({640, 360}, 0.5);
            session.showDebug(tick % 2000 == 0);
            session.draw(canvas);
            REQUIRE_FALSE(canvas.drawing().marks.empty());
        }
    }
    REQUIRE(session.rounds() > 0);
    return session.hash();
}

}  // namespace

TEST_CASE("every game runs for 10000 ticks of random input with 100 seeds, and no body is quarantined",
          "[games][play]") {
    for (const GameInfo& info : test::everyGame()) {
        CAPTURE(info.name);
        for (int seed = 1; seed <= test::cases(100); ++seed)
            playAtRandom(info, static_cast<std::uint64_t>(seed), 10000);
    }
}

TEST_CASE("every game gives the same hash for the same buttons, and another hash with another seed", "[games][play]") {
    for (const GameInfo& info : test::everyGame()) {
        CAPTURE(info.name);
        const std::uint64_t once = playAtRandom(info, 5, 1500);
        CHECK(once == playAtRandom(info, 5, 1500));
        CHECK(once != playAtRandom(info, 6, 1500));
    }
}
