// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include <games/frame/canvas.h>
#include <games/frame/source.h>

#include "catch.h"
#include "games/counting_game.h"
#include "games/every_game.h"
#include "games/shell/tap.h"
#include "games/texts.h"

using namespace plumb;
using namespace plumb::games;
using plumb::test::tap;

namespace {

/// All games, and one with very long texts.
std::vector<GameInfo> gamesToLookAt() {
    std::vector<GameInfo> all = test::everyGame();
    GameInfo wordy = test::countingGame();
    wordy.title = "An uncommonly long title, for all that it says";
    wordy.about = "And a line about it that would not end either if the window did not do so at its right side, here.";
    for (Option& option : wordy.options) option.label = "Something that is to be chosen";
    for (Action& action : wordy.actions) {
        action.about = "does what it says, and some more than that";
        action.keys = {Key::Backspace, Key::Control, Key::Escape};
    }
    all.push_back(wordy);
    return all;
}

/// Checks the texts of the current screen, at five sizes and shapes.
void checkTexts(const Session& session) {
    static const Painter painter;
    for (const PixelSize size : {PixelSize{640, 360}, PixelSize{1280, 720}, PixelSize{1920, 1080}, PixelSize{500, 700},
                                 PixelSize{1000, 300}}) {
        CAPTURE(session.info().name, session.screen(), size.width);
        Canvas canvas(size);
        session.draw(canvas);
        CHECK(test::textsCutOff(canvas.drawing(), painter) == std::vector<std::string>{});
        CHECK(test::textsOverlapping(canvas.drawing(), painter, menuLayer) == std::vector<std::string>{});
    }
}

}  // namespace

TEST_CASE("no text is cut off or overlaps another on any screen of any game, at five sizes", "[games]") {
    for (const GameInfo& info : gamesToLookAt()) {
        const SessionSetup setup{.scores = {123456789, 1000000, 99999, 7000, 6000, 5000, 4000, 300, 20, 1}};
        Session session(info, setup);
        checkTexts(session);
        tap(session, "confirm");
        REQUIRE(session.screen() == Screen::Play);
        checkTexts(session);
        tap(session, "pause");
        REQUIRE(session.screen() == Screen::Pause);
        checkTexts(session);
        tap(session, "up");
        tap(session, "confirm");
        tap(session, "up");
        tap(session, "up");
        tap(session, "confirm");
        REQUIRE(session.screen() == Screen::Scores);
        checkTexts(session);
    }
}

TEST_CASE("no text is cut off at the end of a round that the computer won", "[games]") {
    const GameInfo info = test::countingGame();
    Session session(info, {});
    const auto computer = computerSource(info);
    while (session.screen() != Screen::Over) session.update(*computer->next(session));
    checkTexts(session);
}
