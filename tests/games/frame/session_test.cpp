// SPDX-License-Identifier: MIT
#include <games/frame/session.h>
#include <algorithm>

#include <set>

#include <games/frame/source.h>
#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "games/counting_game.h"

using namespace plumb;
using namespace plumb::games;
using test::containsText;
using test::CountingGame;

namespace {

/// A session of the counting game, and functions that press its buttons.
struct Played {
    Session session;

    explicit Played(const SessionSetup& setup = {}) : session(test::countingGame(), setup) {}

    /// Down for one tick and up for the next.
    void tap(const std::string& action) {
        session.update(session.actions().button(action));
        session.update(0);
    }
    void rest(int ticks) {
        for (int i = 0; i < ticks; ++i) session.update(0);
    }
    const CountingGame& game() const { return static_cast<const CountingGame&>(*session.game()); }
    void winARound() {
        for (int hit = 0; hit < 10; ++hit) tap("hit");
        rest(60);
    }
};

std::vector<std::string> textsOf(const Session& session) {
    Canvas canvas({640, 360});
    session.draw(canvas);
    std::vector<std::string> texts;
    for (const Mark& mark : canvas.drawing().marks)
        if (const auto* text = std::get_if<TextMark>(&mark.shape)) texts.push_back(text->text);
    return texts;
}

bool shows(const Session& session, const std::string& part) {
    for (const std::string& text : textsOf(session))
        if (text.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE(
    "a session leads from the title to a round, a pause, the round, its win by ten hits, the scores and the title",
    "[games]") {
    Played p;
    CHECK(p.session.screen() == Screen::Title);
    CHECK(p.session.game() == nullptr);
    p.tap("confirm");
    REQUIRE(p.session.screen() == Screen::Play);
    CHECK(p.game().ticks == 1);
    p.tap("pause");
    CHECK(p.session.screen() == Screen::Pause);
    p.rest(100);
    CHECK(p.game().ticks == 1);
    p.tap("pause");
    CHECK(p.session.screen() == Screen::Play);
    p.winARound();
    CHECK(p.session.screen() == Screen::Over);
    CHECK(p.session.progress().outcome == Outcome::Won);
    CHECK(p.session.scores() == std::vector<std::int64_t>{100});
    CHECK(shows(p.session, "You won"));
    p.tap("down");
    p.tap("confirm");
    CHECK(p.session.screen() == Screen::Scores);
    p.tap("confirm");
    CHECK(p.session.screen() == Screen::Title);
    CHECK(p.session.rounds() == 1);
}

TEST_CASE("a button that is down since the title is held, but not pressed, in the first tick of the round", "[games]") {
    Played p;
    const Buttons both = p.session.actions().button("confirm") | p.session.actions().button("hit");
    p.session.update(both);
    p.session.update(both);
    CHECK(p.game().hits == 0);
    p.session.update(0);
    p.session.update(both);
    CHECK(p.game().hits == 1);
}

TEST_CASE("the pause menu starts a round with another seed, or leads to the title", "[games]") {
    Played p({.seed = 5});
    p.tap("confirm");
    const std::uint64_t first = p.session.gameSetup().seed;
    CHECK(first == 5);
    p.tap("pause");
    p.tap("down");
    p.tap("confirm");
    CHECK(p.session.screen() == Screen::Play);
    CHECK(p.session.rounds() == 2);
    CHECK(p.session.gameSetup().seed != first);
    p.tap("back");
    p.tap("up");
    p.tap("confirm");
    CHECK(p.session.screen() == Screen::Title);
}

TEST_CASE("at the end of a round, its result stays for two thirds of a second even if confirm is pressed all the time",
          "[games]") {
    Played p;
    p.tap("confirm");
    for (int hit = 0; hit < 10; ++hit) p.tap("hit");
    REQUIRE(p.session.screen() == Screen::Over);
    for (int i = 0; i < 19; ++i) p.tap("confirm");
    CHECK(p.session.screen() == Screen::Over);
    for (int i = 0; i < 2; ++i) p.tap("confirm");
    CHECK(p.session.screen() == Screen::Play);
}

TEST_CASE("the title changes an option with choices, and has no entry for one without", "[games]") {
    Played p;
    CHECK(shows(p.session, "Other"));
    CHECK_FALSE(shows(p.session, "level"));
    p.tap("down");
    p.tap("right");
    CHECK(p.session.gameSetup().option("strength") == "strong");
    p.tap("right");
    CHECK(p.session.gameSetup().option("strength") == "weak");
    p.tap("left");
    p.tap("up");
    p.tap("confirm");
    CHECK(p.session.gameSetup().option("strength") == "strong");
    CHECK(p.session.gameSetup().option("level") == "one");
    CHECK_THROWS_WITH(p.session.gameSetup().option("colour"), containsText("\"colour\""));
}

TEST_CASE("an option of only the command line is not in the title, and its invalid values are refused too", "[games]") {
    GameInfo info = test::countingGame();
    info.options[0].inTitle = false;
    Session session(info, {.options = {{"strength", "strong"}}});
    CHECK_FALSE(shows(session, "Other"));
    CHECK(session.gameSetup().option("strength") == "strong");
    CHECK_THROWS_WITH(Session(info, {.options = {{"strength", "huge"}}}), containsText("\"huge\" is not one of"));
}

TEST_CASE("an unknown option, or a value that is not one of its choices, is refused", "[games]") {
    CHECK_THROWS_WITH(Played({.options = {{"speed", "1"}}}), containsText("\"speed\""));
    CHECK_THROWS_WITH(Played({.options = {{"strength", "huge"}}}), containsText("\"huge\" is not one of weak, strong"));
    CHECK(Played({.options = {{"level", "two"}}}).session.gameSetup().option("level") == "two");
}

TEST_CASE("a banner is not drawn behind a menu, and information for players is not drawn behind the title", "[games]") {
    Played p;
    p.session.update(0);
    CHECK_FALSE(shows(p.session, "hits so far"));
    p.tap("confirm");
    CHECK(shows(p.session, "hits so far"));
    CHECK(shows(p.session, "Ready!"));
    p.tap("pause");
    CHECK(shows(p.session, "hits so far"));
    CHECK_FALSE(shows(p.session, "Ready!"));
}

TEST_CASE("what a game adds to the debug view is shown only in a round", "[games]") {
    Played p;
    p.session.showDebug(true);
    CHECK_FALSE(shows(p.session, "plans"));
    p.tap("confirm");
    CHECK(shows(p.session, "plans"));
    p.session.showDebug(false);
    CHECK_FALSE(shows(p.session, "plans"));
}

TEST_CASE("quit ends the session, and nothing else does", "[games]") {
    Played p;
    p.tap("back");
    CHECK_FALSE(p.session.ended());
    p.tap("up");
    p.tap("confirm");
    CHECK(p.session.ended());
}

TEST_CASE("the ten best scores are kept, the best first, and the end of a round shows its rank among them", "[games]") {
    Played p({.scores = {5, 400, 90, 80, 70, 60, 50, 40, 30, 20, 10}});
    CHECK(p.session.scores().size() == 10);
    CHECK(p.session.scores().front() == 400);
    p.tap("confirm");
    p.winARound();
    CHECK(p.session.scores()[1] == 100);
    CHECK(p.session.scores().size() == 10);
    CHECK(shows(p.session, "number 2 of the best"));
    p.tap("confirm");
    p.tap("give-up");
    CHECK(p.session.screen() == Screen::Over);
    CHECK(shows(p.session, "Game over"));
    CHECK(shows(p.session, "the best so far: 400"));
    CHECK(p.session.scores().back() == 20);
}

TEST_CASE("each hit of a round plays one cue, and the game behind the title plays none", "[games]") {
    Played p;
    p.rest(200);
    CHECK(p.session.takeCues().empty());
    p.tap("confirm");
    p.session.takeCues();
    p.tap("hit");
    p.tap("hit");
    CHECK(p.session.takeCues().size() == 2);
    CHECK(p.session.takeCues().empty());
}

TEST_CASE("a round is drawn between two ticks, at the part of the tick that has passed, a paused one is drawn at 1",
          "[games]") {
    Played p;
    p.tap("confirm");
    const auto seen = [&] {
        Canvas canvas({640, 360}, 0.25);
        p.session.draw(canvas);
        CHECK(canvas.between() == 0.25);
        return std::get<EllipseMark>(canvas.drawing().marks[1].shape).center.x();
    };
    CHECK(seen() == 0.25);
    p.tap("pause");
    CHECK(seen() == 1);
}

TEST_CASE("two sessions with the same buttons agree at every tick, through all five screens", "[games]") {
    std::set<Screen> met;
    for (int seed = 0; seed < std::max(5, test::cases(100)); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Played a({.seed = 9}), b({.seed = 9});
        Buttons buttons = 0;
        for (int tick = 0; tick < 2000 && !a.session.ended(); ++tick) {
            if (random.integer(0, 2) == 0)
                buttons = Buttons{1} << random.integer(0, a.session.actions().size() - 1);
            else if (random.integer(0, 2) == 0)
                buttons = 0;
            a.session.update(buttons);
            b.session.update(buttons);
            met.insert(a.session.screen());
            REQUIRE(a.session.hash() == b.session.hash());
            REQUIRE(a.session.screen() == b.session.screen());
        }
    }
    CHECK(met.size() == 5);
}

TEST_CASE("the computer starts the session by itself, wins, and plays again", "[games]") {
    Session session(test::countingGame(), {});
    const auto computer = computerSource(test::countingGame());
    for (int tick = 0; tick < 1000; ++tick) session.update(*computer->next(session));
    CHECK(session.rounds() > 5);
    CHECK(session.scores() == std::vector<std::int64_t>(10, 100));
    GameInfo lonely = test::countingGame();
    lonely.computer = nullptr;
    CHECK_THROWS_WITH(computerSource(lonely), containsText("counting has no computer player"));
}

TEST_CASE("behind the title the computer plays, or the game draws its own title, neither changes the session",
          "[games]") {
    GameInfo other = test::countingGame();
    double shown = -1;
    other.drawTitle = [&](Canvas&, double seconds) { shown = seconds; };
    Session played(test::countingGame(), {}), drawn(other, {});
    for (int tick = 0; tick < 120; ++tick) {
        played.update(0);
        drawn.update(0);
    }
    Canvas canvas({640, 360});
    drawn.draw(canvas);
    CHECK_THAT(shown, Catch::Matchers::WithinAbs(2, 1e-12));
    CHECK(played.hash() == drawn.hash());
}
