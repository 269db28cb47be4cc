// SPDX-License-Identifier: MIT
#include <games/runner/stage.h>

#include <algorithm>
#include <functional>

#include <games/runner/level_text.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games::runner;

namespace {

Stage stageOf(const std::string& rows, const std::string& profile = "modern") {
    return Stage(std::make_shared<const Level>(readLevel("map:\n" + rows, "test")), {profile, 1});
}

/// Plays so many ticks, and counts the events of a kind.
int play(Stage& stage, int ticks, const std::function<PlatformInput(int)>& input, EventKind kind = EventKind::Jumped) {
    int seen = 0;
    for (int tick = 0; tick < ticks; ++tick) {
        stage.update(input(tick));
        for (const Event& event : stage.events()) seen += event.kind == kind ? 1 : 0;
    }
    return seen;
}

PlatformInput stand(int) {
    return {};
}

/// How far the hero's place rises above where it stands [px of 1985].
double apexOf(Stage stage, int heldTicks) {
    play(stage, 30, stand);
    const double floor = stage.heroAt().y();
    double highest = floor;
    for (int tick = 0; tick < 90; ++tick) {
        stage.update({.jump = tick < heldTicks});
        highest = std::max(highest, stage.heroAt().y());
    }
    return 16 * (highest - floor);
}

const std::string openField = "........\n........\n........\n........\n........\n........\nS......G\n########\n";

}  // namespace

TEST_CASE("by the tables of 1985 a jump rises 66 px held and 24 px tapped, 16 px a tile", "[games][runner][arcade]") {
    // 4096ths of a pixel are exact in a double; what rounds is the place in the world, by 1e-15 of some metres.
    CHECK(apexOf(stageOf(openField, "1985"), 90) == Approx(66).margin(1e-9));
    CHECK(apexOf(stageOf(openField, "1985"), 1) == Approx(24).margin(1e-9));
}

TEST_CASE("today's jump rises 4.3 m held, and is shorter the sooner it is let go", "[games][runner]") {
    CHECK(apexOf(stageOf(openField), 90) == Approx(16 * 4.3).margin(0.01));
    CHECK(apexOf(stageOf(openField), 1) < apexOf(stageOf(openField), 8));
    CHECK(apexOf(stageOf(openField), 8) < apexOf(stageOf(openField), 90) - 8);
}

TEST_CASE("who falls on a snuffer stomps it, is thrown up and unhurt; who walks into one is hurt", "[games][runner]") {
    for (const std::string profile : {"1985", "modern"}) {
        INFO(profile);
        // The snuffer is walled in, 2 m wide; the hero falls onto it.
        Stage stage = stageOf(".S....\n......\n......\n#..#..\n#w.#.G\n######\n", profile);
        CHECK(play(stage, 90, stand, EventKind::Stomped) == 1);
        CHECK_FALSE(stage.walkers()[0].alive);
        CHECK(stage.hero().tall);
        Stage other = stageOf("......\n......\nS.w#.G\n######\n", profile);
        CHECK(play(other, 120, [](int) { return PlatformInput{.move = 1}; }, EventKind::Hurt) == 1);
        CHECK_FALSE(other.hero().tall);
        CHECK(other.hero().alive);
    }
}

TEST_CASE("a burr hurts from above, and a second hurt ends it", "[games][runner]") {
    Stage stage = stageOf(".S....\n......\n......\n#..#..\n#u.#.G\n######\n");
    CHECK(play(stage, 600, stand, EventKind::Hurt) == 1);
    CHECK_FALSE(stage.hero().alive);
    CHECK(stage.walkers()[0].alive);
}

TEST_CASE("a spring throws 7.2 m up in both profiles, whatever is held", "[games][runner]") {
    for (const std::string profile : {"1985", "modern"})
        for (const bool jump : {false, true}) {
            INFO(profile << ' ' << jump);
            Stage stage = stageOf("...\n...\n...\n...\n...\n...\n...\n...\nS..\n...\ns.G\n###\n", profile);
            double highest = 0;
            bool sprung = false;
            for (int tick = 0; tick < 150; ++tick) {
                stage.update({.jump = jump});
                for (const Event& event : stage.events()) sprung = sprung || event.kind == EventKind::Sprung;
                if (sprung) highest = std::max(highest, stage.heroAt().y());
            }
            // From the spring's top, 1.5 m, and a skin; the tables' apex is v / 2 of a tick higher: 0.17 m.
            const double from = 1.5 + heroHalf.y();
            CHECK(highest - from > 7.2 - 0.01);
            CHECK(highest - from < 7.2 + (profile == "1985" ? 0.2 : 0.02));
        }
}

TEST_CASE("a crate is pushed along in both profiles, and is a step to stand on", "[games][runner]") {
    for (const std::string profile : {"1985", "modern"}) {
        INFO(profile);
        Stage stage = stageOf("..........\n..........\nS.x......G\n##########\n", profile);
        play(stage, 60, [](int) { return PlatformInput{.move = 1}; });
        const BodyId crate = stage.crates()[0].body;
        CHECK(stage.world().body(crate).position().x() > 3.5);
        CHECK(stage.heroAt().x() < stage.world().body(crate).position().x());
        play(stage, 60, stand);
        play(stage, 80, [](int tick) { return PlatformInput{.move = tick > 6 && tick < 24 ? 1.0 : 0.0, .jump = tick < 20}; });
        // Its top is at 1 + 2 x 0.48; the hero's middle 0.45 above, and both keep a skin.
        CHECK(stage.heroAt().y() == Approx(1 + 2 * crateHalf + heroHalf.y()).margin(0.02));
    }
}

TEST_CASE("a crate that falls on a snuffer squashes it", "[games][runner]") {
    // It is pushed over the edge into a pit 1 m wide.
    Stage stage = stageOf("......\nS.x..G\n###.##\n###.##\n###.##\n###w##\n######\n");
    CHECK(play(stage, 150, [](int) { return PlatformInput{.move = 0.6}; }, EventKind::Squashed) == 1);
    CHECK_FALSE(stage.walkers()[0].alive);
}

TEST_CASE("who dies begins again at the last lantern lit, with what was taken still taken", "[games][runner]") {
    Stage stage = stageOf("..........\n..........\nS.o.C.....\n#######~~G\n#######~~#\n");
    play(stage, 200, [](int) { return PlatformInput{.move = 1}; });
    REQUIRE_FALSE(stage.hero().alive);
    stage.beginAgain();
    CHECK(stage.hero().alive);
    CHECK(stage.heroAt().x() == Approx(4.5));
    CHECK(stage.treasures()[0].taken);
    CHECK(stage.lanterns()[0].lit);
    CHECK(stage.ticks() == 0);
}

TEST_CASE("a brick breaks and a lamp lights once from below", "[games][runner]") {
    Stage stage = stageOf("b..\n...\n...\nS.G\n###\n");
    CHECK(play(stage, 60, [](int tick) { return PlatformInput{.jump = tick > 10}; }, EventKind::BrickBroke) == 1);
    CHECK(isEmpty(stage.tiles().at({0, 4})));
    Stage other = stageOf("?..\n...\n...\nS.G\n###\n");
    CHECK(play(other, 240, [](int tick) { return PlatformInput{.jump = tick % 60 > 10}; }, EventKind::LampLit) == 1);
}

TEST_CASE("thorns hurt who stands on them, and leave a hop to get away", "[games][runner]") {
    Stage stage = stageOf("....\nS..G\n^^##\n####\n");
    CHECK(play(stage, 20, stand, EventKind::Hurt) == 1);
    CHECK(stage.hero().mover.slide().velocity.y() > 0);
}

TEST_CASE("a lift carries who stands on it, to a skin", "[games][runner]") {
    Stage stage = stageOf("...S.....G\n..ppp---..\n..........\n", "modern");
    play(stage, 60, stand);
    REQUIRE(stage.hero().mover.slide().isOnFloor);
    const double before = stage.heroAt().x() - stage.world().body(stage.lifts()[0].body).position().x();
    play(stage, 200, stand);
    const double after = stage.heroAt().x() - stage.world().body(stage.lifts()[0].body).position().x();
    CHECK(after == Approx(before).margin(1e-9));
}
