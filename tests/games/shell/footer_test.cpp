// SPDX-License-Identifier: MIT
#include <games/frame/footer.h>

#include <games/frame/canvas.h>
#include <games/frame/source.h>
#include <games/shell/desktop/frame_times.h>
#include <plumb/plumb.h>

#include "catch.h"
#include "games/counting_game.h"
#include "games/every_game.h"
#include "games/shell/tap.h"
#include "games/texts.h"

using namespace plumb;
using namespace plumb::games;
using plumb::test::tap;

namespace {

constexpr PixelSize sizes[] = {{640, 360}, {1280, 720}, {1920, 1080}, {500, 700}, {1000, 300}, {320, 180}};

/// What F2 shows after a second, with long numbers.
FooterLine someTimes() {
    FrameTimes times;
    for (int i = 0; i < 60; ++i) {
        times.addTick(0.01234);
        times.addFrame(0.12345, 0.00123);
    }
    return times.figures();
}

/// The rectangle of the footer. Without a footer: one that lies below the window.
Aabb footerOf(const Drawing& drawing) {
    for (const Mark& mark : drawing.marks) {
        const auto* rect = std::get_if<RectMark>(&mark.shape);
        if (rect == nullptr || mark.layer != footerLayer) continue;
        return {mark.toPixels * rect->corner, mark.toPixels * Vec2(rect->corner + rect->size)};
    }
    return {{0, 1e6}, {0, 1e6}};
}

/// One sentence for each text of the picture that the footer hides, and for each of its own that reaches out of it.
std::vector<std::string> textsHidden(const Drawing& drawing, const Painter& painter) {
    std::vector<std::string> faults;
    const Aabb footer = footerOf(drawing);
    for (const Mark& mark : drawing.marks) {
        const auto* text = std::get_if<TextMark>(&mark.shape);
        if (text == nullptr) continue;
        const Aabb box = painter.boxOf(mark);
        if (mark.layer == footerLayer && !contains(footer, box)) faults.push_back(text->text + " is not in the footer");
        if (mark.layer != footerLayer && overlap(footer, box)) faults.push_back(text->text + " is hidden");
    }
    return faults;
}

/// Checks the texts of the current screen, with F1 and F2 on.
void checkFooter(const Session& session) {
    static const Painter painter;
    for (const PixelSize size : sizes) {
        CAPTURE(session.info().name, session.screen(), session.ticks(), size.width);
        Canvas canvas(size);
        session.draw(canvas, {someTimes()});
        CHECK(textsHidden(canvas.drawing(), painter) == std::vector<std::string>{});
        CHECK(test::textsOverlapping(canvas.drawing(), painter, footerLayer) == std::vector<std::string>{});
        for (const Mark& mark : canvas.drawing().marks)
            if (mark.layer == debugLayer) CHECK_FALSE(std::holds_alternative<TextMark>(mark.shape));
    }
}

bool hasText(const Drawing& drawing, const std::string& part, int layer) {
    for (const Mark& mark : drawing.marks)
        if (const auto* text = std::get_if<TextMark>(&mark.shape))
            if (mark.layer == layer && text->text.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("the texts of F1 and F2 hide no text of a menu or a game, on any screen, at six sizes", "[games]") {
    for (const GameInfo& info : test::everyGame()) {
        Session session(info, {.scores = {5000, 4000, 300, 20, 1}});
        session.showDebug(true);
        checkFooter(session);
        tap(session, "confirm");
        REQUIRE(session.screen() == Screen::Play);
        checkFooter(session);
        const auto computer = info.computer ? computerSource(info) : nullptr;
        for (int second = 0; second < 10 && session.screen() == Screen::Play; ++second) {
            for (int tick = 0; tick < 60; ++tick) session.update(computer ? *computer->next(session) : 0);
            checkFooter(session);
        }
        REQUIRE(session.screen() == Screen::Play);
        tap(session, "pause");
        REQUIRE(session.screen() == Screen::Pause);
        checkFooter(session);
        for (const char* action : {"up", "confirm", "up", "up", "confirm"}) tap(session, action);
        REQUIRE(session.screen() == Screen::Scores);
        checkFooter(session);
    }
}

TEST_CASE("the debug view is drawn below menus, and below the information for players", "[games]") {
    CHECK(debugLayer < hudLayer);
    CHECK(hudLayer < menuLayer);
    for (const auto& [name, told] : {std::pair{"artillery", "wind"}, {"runner", "Level 1"}})
        for (const GameInfo& info : test::everyGame()) {
            if (info.name != name) continue;
            CAPTURE(name);
            Session session(info, {});
            session.showDebug(true);
            tap(session, "confirm");
            Canvas canvas({640, 360});
            session.draw(canvas);
            CHECK(hasText(canvas.drawing(), told, hudLayer));
        }
}

TEST_CASE(
    "the lines from cats to their targets end at the edge of the maze, so that they do not cross the score beside it",
    "[games]") {
    constexpr double left = 146, right = 496;  // the columns at its sides reach to these [pixels]
    for (const GameInfo& info : test::everyGame()) {
        if (info.name != "maze") continue;
        Session session(info, {});
        session.showDebug(true);
        tap(session, "confirm");
        for (int tick = 0; tick < 400; ++tick) session.update(0);
        Canvas canvas({640, 360});
        session.draw(canvas);
        int marks = 0;
        for (const Mark& mark : canvas.drawing().marks) {
            if (mark.layer != debugLayer) continue;
            REQUIRE(mark.clip >= 0);
            const Clip& clip = canvas.drawing().clips[static_cast<std::size_t>(mark.clip)];
            CHECK(clip.corner.x() > left);
            CHECK(clip.corner.x() + clip.size.x() < right);
            ++marks;
        }
        CHECK(marks > 3);
    }
}

TEST_CASE("the figures of the world are shown in a round and behind its menus, but not in the title", "[games]") {
    for (const GameInfo& info : test::everyGame()) {
        if (info.name != "bounce") continue;
        Session session(info, {});
        session.showDebug(true);
        const auto tells = [&] {
            Canvas canvas({640, 360});
            session.draw(canvas);
            return hasText(canvas.drawing(), "2 bodies", footerLayer);
        };
        CHECK_FALSE(tells());
        tap(session, "confirm");
        CHECK(tells());
        tap(session, "pause");
        CHECK(tells());
        session.showDebug(false);
        CHECK_FALSE(tells());
    }
}

TEST_CASE("a picture ends where the footer begins, at a whole pixel, without a footer it fills the window", "[games]") {
    for (const PixelSize size : sizes)
        for (const std::size_t lines : {0u, 1u, 2u}) {
            CAPTURE(size.width, lines);
            Canvas canvas(size);
            drawFooter(canvas, std::vector<FooterLine>(lines, {"a", "b"}), {});
            const Aabb screen = canvas.visible();
            canvas.circle(screen.upper, 1, Color{});
            const Mark& corner = canvas.drawing().marks.back();
            const Vec2 end = corner.toPixels * std::get<EllipseMark>(corner.shape).center;
            CHECK_THAT(end.x(), Catch::Matchers::WithinAbs(size.width, 1e-9));
            CHECK(corner.layer == 0);
            const double top = lines == 0 ? size.height : footerOf(canvas.drawing()).lower.y();
            CHECK_THAT(end.y(), Catch::Matchers::WithinAbs(top, 1e-9));
            CHECK_THAT(top, Catch::Matchers::WithinAbs(std::round(top), 1e-9));
            CHECK(contains(screen, Aabb{{1e-9, 1e-9}, {screenWidth - 1e-9, screenHeight - 1e-9}}));
        }
}
