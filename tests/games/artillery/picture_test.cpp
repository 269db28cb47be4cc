// SPDX-License-Identifier: MIT
// What does the picture of a battle tell?
#include <games/artillery/artillery.h>
#include <games/artillery/hud.h>

#include <algorithm>

#include "catch.h"

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::artillery;

namespace {

constexpr PixelSize desktop{1280, 720}, phone{780, 1068};
const Buttons fireButton = buttonsOf({.fire = true}), upButton = buttonsOf({.up = true});

/// A game, and the buttons of the tick before.
class Held {
public:
    explicit Held(const std::string& rival, std::uint64_t seed = 3)
        : game_({seed, {{"rival", rival}, {"line", "off"}, {"strength", "strong"}}}) {}

    void hold(Buttons now) {
        game_.update(Input(actions_, now, before_));
        before_ = now;
    }
    const Artillery& game() const { return game_; }
    const Battle& battle() const { return game_.match().battle(); }
    std::vector<Cue> takeCues() { return game_.takeCues(); }
    bool rivalAims() const { return !game_.match().isPersonsTurn() && battle().phase() == Phase::Aim; }
    bool personAims() const { return game_.match().isPersonsTurn() && battle().phase() == Phase::Aim; }

private:
    ActionList actions_{artillery::info().actions};
    Artillery game_;
    Buttons before_ = 0;
};

Drawing pictureOf(const Artillery& game, PixelSize size) {
    Canvas canvas(size);
    game.draw(canvas);
    return canvas.drawing();
}

bool tells(const Artillery& game, PixelSize size, const std::string& wanted) {
    const Drawing drawing = pictureOf(game, size);
    return std::any_of(drawing.marks.begin(), drawing.marks.end(), [&](const Mark& mark) {
        const auto* text = std::get_if<TextMark>(&mark.shape);
        return text != nullptr && text->text == wanted;
    });
}

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool hasArrowText(const Drawing& drawing) {
    return std::any_of(drawing.marks.begin(), drawing.marks.end(), [](const Mark& mark) {
        const auto* text = std::get_if<TextMark>(&mark.shape);
        return text != nullptr && (endsWith(text->text, " m high") || endsWith(text->text, " m away"));
    });
}

/// Whether the middle of the shell is in the picture.
bool isInSight(const Artillery& game, PixelSize size) {
    Canvas canvas(size);
    game.draw(canvas);
    const Aabb seen = canvas.visible();
    const Battle& battle = game.match().battle();
    const Vec2 at = battle.world().body(battle.shell()->body).position();
    return at.cwiseMax(seen.lower).cwiseMin(seen.upper) == at;
}

}  // namespace

TEST_CASE("a shell out of sight has an arrow at the edge that points to it, and a shell in sight has none",
          "[games][artillery]") {
    const Aabb seen{{-30, -5}, {30, 30}}, inner{{-28, 0}, {28, 25}};
    for (const Vec2& shell : {Vec2(-45, 12), Vec2(33, 4), Vec2(3, 48), Vec2(41, 41), Vec2(10, 30.5)}) {
        const auto mark = shellMarkOf(shell, seen, inner, 1);
        REQUIRE(mark);
        CHECK(mark->tip.cwiseMax(inner.lower).cwiseMin(inner.upper) == mark->tip);
        const Vec2 way = shell - mark->tip;
        CHECK_THAT(way.dot(mark->towards), Catch::Matchers::WithinAbs(way.norm(), 1e-12));
    }
    CHECK(shellMarkOf({3, 48}, seen, inner, 1)->text == "47 m high");
    CHECK(shellMarkOf({-45, 12}, seen, inner, 1)->text == "15 m away");
    for (const Vec2& shell : {Vec2(0, 0), Vec2(-29.9, 12), Vec2(3, 29), Vec2(29, -4)})
        CHECK_FALSE(shellMarkOf(shell, seen, inner, 1));
}

TEST_CASE("a shot that leaves the picture has an arrow exactly as long as it is out of sight", "[games][artillery]") {
    Held held("friend");
    int away = 0;
    for (int tick = 0; tick < 1500; ++tick) {
        held.hold(held.battle().phase() == Phase::Aim ? fireButton : 0);  // it fires at the full charge
        if (!held.battle().shell()) continue;
        const bool sees = isInSight(held.game(), desktop);
        REQUIRE(hasArrowText(pictureOf(held.game(), desktop)) != sees);
        away += sees ? 0 : 1;
    }
    CHECK(away > 20);
}

TEST_CASE("a press in the rival's turn is answered by a text and a sound, and changes nothing else",
          "[games][artillery]") {
    for (const Buttons button : {fireButton, upButton}) {
        Held pressing("weak"), waiting("weak");
        while (!pressing.rivalAims()) {
            const Buttons shot =
                pressing.battle().phase() == Phase::Aim && pressing.battle().phaseTicks() < 9 ? fireButton : 0;
            pressing.hold(shot);
            waiting.hold(shot);
        }
        for (const PixelSize size : {desktop, phone}) CHECK_FALSE(tells(pressing.game(), size, "Wait: the Tides aim"));
        pressing.takeCues();
        waiting.takeCues();
        pressing.hold(button);
        waiting.hold(0);
        for (const PixelSize size : {desktop, phone}) {
            CHECK(tells(pressing.game(), size, "Wait: the Tides aim"));
            CHECK_FALSE(tells(waiting.game(), size, "Wait: the Tides aim"));
        }
        CHECK(pressing.takeCues().size() == waiting.takeCues().size() + 1);
        for (int tick = 0; tick < 100; ++tick) {
            pressing.hold(0);
            waiting.hold(0);
            REQUIRE(pressing.game().hash() == waiting.game().hash());
        }
        CHECK_FALSE(tells(pressing.game(), desktop, "Wait: the Tides aim"));
    }
}

TEST_CASE("the picture says whose turn it is", "[games][artillery]") {
    Held held("weak"), friends("friend");
    bool yours = false, theirs = false, second = false;
    for (int tick = 0; tick < 2400; ++tick) {
        const Buttons shot = held.personAims() && held.battle().phaseTicks() < 9 ? fireButton : 0;
        held.hold(shot);
        friends.hold(friends.battle().phase() == Phase::Aim && friends.battle().phaseTicks() < 9 ? fireButton : 0);
        if (tick % 3 != 0 || held.battle().phase() == Phase::Ready) continue;
        for (const PixelSize size : {desktop, phone}) {
            REQUIRE(tells(held.game(), size, "Your turn") == held.personAims());
            REQUIRE(tells(held.game(), size, "The Tides aim") == held.rivalAims());
        }
        yours = yours || held.personAims();
        theirs = theirs || held.rivalAims();
        if (friends.battle().phase() != Phase::Aim) continue;
        const bool tides = friends.battle().crew() == 1;
        REQUIRE(tells(friends.game(), desktop, tides ? "Tides: your turn" : "Embers: your turn"));
        second = second || tides;
    }
    CHECK((yours && theirs && second));
}
