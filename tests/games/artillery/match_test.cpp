// SPDX-License-Identifier: MIT
#include <games/artillery/artillery.h>

#include <games/frame/source.h>
#include <plumb/record/state_hash.h>
#include <cmath>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::artillery;

namespace {

GameInfo named() {
    GameInfo game = artillery::info();
    game.name = "artillery";
    return game;
}

/// The computer plays a game from the title to its end.
Progress playedOut(std::uint64_t seed, const std::string& strength, const std::string& rival) {
    const GameInfo game = named();
    Session session(game, {seed, {{"strength", strength}, {"rival", rival}}, {}});
    const auto computer = computerSource(game);
    while (session.screen() != Screen::Over && session.ticks() < 200'000) session.update(*computer->next(session));
    REQUIRE(session.screen() == Screen::Over);
    return session.progress();
}

/// Random buttons, each held for a while, as a person who does not know the game.
Buttons anyButtons(Random& random, Buttons before) {
    return random.integer(0, 11) == 0 ? static_cast<Buttons>(random.integer(0, 63)) : before;
}

std::uint64_t hashAfter(std::uint64_t seed, std::uint64_t buttonsSeed, int ticks) {
    const GameInfo game = named();
    Session session(game, {seed, {}, {}});
    Random random(buttonsSeed);
    session.update(session.actions().button("confirm"));
    Buttons buttons = 0;
    for (int tick = 0; tick < ticks; ++tick) session.update(buttons = anyButtons(random, buttons));
    return session.hash();
}

/// Where an object is inside the ground or below it; empty: no such object.
std::optional<Vec2> lostIn(const Battle& battle) {
    const Terrain& ground = battle.terrain();
    for (const Gunner& gunner : battle.gunners()) {
        const Vec2 at = battle.middleOf(gunner);
        if (gunner.alive && !(at.y() > ground.heightAt(at.x()))) return at;
    }
    for (const Prop& prop : battle.props()) {
        const Vec2 at = battle.world().body(prop.body).position();
        if (std::abs(at.x()) > worldEdge) continue;  // thrown off the map: removed at the end of the turn
        if (!(at.y() > ground.heightAt(at.x()) - 0.5)) return at;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("the strong crew beats the weak one in at least 80 of 100 battles", "[games][artillery][slow]") {
    const int battles = plumb::test::cases(100);
    int won = 0;
    for (int seed = 1; seed <= battles; ++seed)
        won += playedOut(static_cast<std::uint64_t>(seed), "strong", "weak").outcome == Outcome::Won;
    REQUIRE(won * 100 >= battles * 80);
}

TEST_CASE("a weak crew wins fewer than half of 50 battles against a strong one", "[games][artillery][slow]") {
    const int battles = plumb::test::cases(50);
    int won = 0;
    for (int seed = 1; seed <= battles; ++seed)
        won += playedOut(static_cast<std::uint64_t>(seed), "weak", "strong").outcome == Outcome::Won;
    REQUIRE(won * 2 < battles);
}

TEST_CASE("the same seed and buttons give the same battle to the last bit, another seed or other buttons do not",
          "[games][artillery]") {
    const std::uint64_t hash = hashAfter(3, 4, 3000);
    REQUIRE(hashAfter(3, 4, 3000) == hash);
    REQUIRE(hashAfter(4, 4, 3000) != hash);
    REQUIRE(hashAfter(3, 5, 3000) != hash);
}

TEST_CASE("after a shell's blast of 3.6 m everything stands still for 3 ticks, one for each whole metre",
          "[games][artillery]") {
    const GameInfo game = named();
    const GameSetup setup{1, {{"rival", "weak"}, {"line", "off"}, {"strength", "strong"}}};
    Artillery round(setup);
    const auto computer = game.computer(setup);
    const ActionList actions(game.actions);
    const Battle& battle = round.match().battle();
    while (battle.phase() != Phase::Settle) round.update(Input(actions, computer->decide(round), 0));
    const std::uint64_t hash = stateHash(battle.world());
    for (int tick = 0; tick < 3; ++tick) {
        round.update(Input(actions, 0, 0));
        REQUIRE(stateHash(battle.world()) == hash);
    }
    round.update(Input(actions, 0, 0));
    REQUIRE(stateHash(battle.world()) != hash);
}

TEST_CASE("in 10,000 ticks of random buttons nothing falls through the ground or out of the world",
          "[games][artillery]") {
    const GameInfo game = named();
    const ActionList actions(game.actions);
    for (int seed = 1; seed <= plumb::test::cases(30); ++seed) {
        Artillery round({static_cast<std::uint64_t>(seed), {{"rival", "weak-to-strong"}, {"line", "short"}}});
        Random random(static_cast<std::uint64_t>(seed));
        Buttons before = 0;
        for (int tick = 0; tick < 10'000 && round.progress().outcome == Outcome::Running; ++tick) {
            const Buttons now = anyButtons(random, before);
            round.update(Input(actions, now, before));
            before = now;
            const Battle& battle = round.match().battle();
            CAPTURE(seed, tick);
            REQUIRE(battle.world().quarantines().empty());
            REQUIRE_FALSE(lostIn(battle).has_value());
        }
    }
}

TEST_CASE("a rival of each strength has its own island, with that island's tide and at most its wind",
          "[games][artillery]") {
    for (const Stage& stage : stages)
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Match match(seed, std::string(stage.rival));
            REQUIRE(stages[static_cast<std::size_t>(match.stage())].name == stage.name);
            REQUIRE(match.battle().tideTurn() == stage.tideTurn);
            REQUIRE(std::abs(match.battle().wind()) <= stage.wind);
        }
}

TEST_CASE("an unknown option value is refused by name before the game begins", "[games][artillery]") {
    const GameInfo game = named();
    for (const char* option : {"strength", "rival", "line"})
        REQUIRE_THROWS_WITH(Session(game, {1, {{option, "mighty"}}, {}}), plumb::test::containsText("\"mighty\""));
}
