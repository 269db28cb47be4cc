// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include <array>

#include <games/frame/session.h>

#include "catch.h"
#include "games/every_game.h"

using namespace plumb;
using namespace plumb::games;

namespace {

/// Where a menu's text is drawn [pixels].
Vec2 pixelOf(const Session& session, PixelSize size, const std::string& words) {
    Canvas canvas(size);
    session.draw(canvas);
    for (const Mark& mark : canvas.drawing().marks) {
        const auto* text = std::get_if<TextMark>(&mark.shape);
        if (text != nullptr && text->text.starts_with(words)) return mark.toPixels * text->at;
    }
    FAIL("\"" << words << "\" is not drawn");
    return {0, 0};
}

void click(Session& session, PixelSize size, const Vec2& pixel) {
    for (const Buttons buttons : session.pressesAt(pixel, size)) session.update(buttons);
}

constexpr std::array sizes = {PixelSize{1280, 720}, PixelSize{390, 540}, PixelSize{820, 820}, PixelSize{1920, 400}};

}  // namespace

TEST_CASE("a click on what a menu draws chooses it, in windows of four shapes and in every game", "[games]") {
    for (const GameInfo& info : test::everyGame()) {
        for (const PixelSize size : sizes) {
            CAPTURE(info.name, size.width, size.height);
            Session session(info, {});
            click(session, size, pixelOf(session, size, "Best scores"));
            CHECK(session.screen() == Screen::Scores);
            click(session, size, pixelOf(session, size, "To the title"));
            CHECK(session.screen() == Screen::Title);
            click(session, size, pixelOf(session, size, "Play"));
            CHECK(session.screen() == Screen::Play);
            session.update(session.actions().button("pause"));
            session.update(0);
            click(session, size, pixelOf(session, size, "Go on"));
            CHECK(session.screen() == Screen::Play);
        }
    }
}

TEST_CASE("a click on the right half of an option takes the next value, on the left half the one before", "[games]") {
    for (const GameInfo& info : test::everyGame()) {
        if (info.name != "artillery") continue;
        for (const PixelSize size : sizes) {
            Session session(info, {});
            const Vec2 middle = pixelOf(session, size, "Aim line"), aside(size.width / 50.0, 0);
            click(session, size, middle + aside);
            CHECK(session.gameSetup().option("line") == "full");
            click(session, size, middle - aside);
            CHECK(session.gameSetup().option("line") == "short");
        }
    }
}

TEST_CASE("a click chooses what is drawn there, also above a footer and the debug view's lines", "[games]") {
    for (const GameInfo& info : test::everyGame()) {
        const PixelSize size{640, 360};
        const std::vector<FooterLine> footer(3, {"a line"});
        Session session(info, {});
        session.showDebug(true);
        click(session, size, pixelOf(session, size, "Play"));
        session.update(session.actions().button("pause"));
        session.update(0);
        Canvas canvas(size);
        session.draw(canvas, footer);
        for (const Mark& mark : canvas.drawing().marks) {
            const auto* text = std::get_if<TextMark>(&mark.shape);
            if (text == nullptr || text->text != "To the title") continue;
            for (const Buttons buttons : session.pressesAt(mark.toPixels * text->at, size, footer))
                session.update(buttons);
        }
        CHECK(session.screen() == Screen::Title);
    }
}

TEST_CASE("a click beside a menu presses nothing", "[games]") {
    const Session session(test::everyGame().front(), {});
    CHECK(session.pressesAt({3, 3}, {1280, 720}).empty());
    CHECK(session.pressesAt({640, 700}, {1280, 720}).empty());
    CHECK(session.pressesAt({640 - 230, 320}, {1280, 720}).empty());
}

TEST_CASE("menus keep their size in wide windows, and are twice as large where twice as high", "[games]") {
    CHECK(screenPlace({{0, 0}, {640, 360}}).scale.x() == 1);
    CHECK(screenPlace({{-200, 0}, {840, 360}}).scale.x() == 1);
    CHECK(screenPlace({{0, -90}, {640, 450}}).scale.x() == Approx(1.5));
    CHECK(screenPlace({{0, -400}, {640, 760}}).scale.x() == 2);
}
