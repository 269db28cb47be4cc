// SPDX-License-Identifier: MIT
#include <games/runner/stage.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <games/runner/level_text.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games::runner;

namespace {

Stage stageOf(const std::string& rows, const std::string& profile = "modern") {
    return Stage(std::make_shared<const Level>(readLevel("map:\n" + rows, "test")), {profile, 1});
}

/// Plays this many ticks, and counts the events of one kind.
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

/// How far the hero rises above its place on the floor, and after how many ticks it is on the floor again.
struct Jump {
    double pixels = 0;  ///< of 1985: 16 to the metre
    int ticks = 0;
};

/// A jump after a run-up of runUp ticks, with jump held for heldTicks.
Jump jumpOf(Stage stage, int heldTicks, int runUp = 30, PlatformInput input = {}) {
    play(stage, 30, stand);
    play(stage, runUp, [&](int) { return input; });
    const double floor = stage.heroAt().y();
    Jump jump;
    double highest = floor;
    do {
        input.jump = jump.ticks < heldTicks;
        stage.update(input);
        highest = std::max(highest, stage.heroAt().y());
        ++jump.ticks;
    } while (!stage.hero().mover.slide().isOnFloor && jump.ticks < 200);
    jump.pixels = 16 * (highest - floor);
    return jump;
}

std::string fieldOf(int columns) {
    const std::string air(static_cast<std::size_t>(columns - 2), '.');
    std::string rows;
    for (int row = 0; row < 7; ++row) rows += "." + air + ".\n";
    return rows + "S" + air + "G\n#" + std::string(air.size(), '#') + "#\n";
}

/// The apex of a jump by the tables of 1985 [1/256 pixel]. Each tick, the height changes by the speed, then gravity
/// reduces the speed. The fall gravity replaces the rise gravity once jump is released or the hero stops rising.
int apexOfTables(int takeOff, int riseGravity, int fallGravity, int heldTicks) {
    int height = 0, speed = takeOff * 256;
    for (int tick = 0; speed > 0; ++tick) {
        const bool letGo = tick >= heldTicks && height >= 256;
        height += speed;
        speed -= letGo ? fallGravity : riseGravity;
    }
    return height;
}

}  // namespace

TEST_CASE("by the tables of 1985 a held jump rises 66 px and takes 53 ticks, a tapped jump 24 px and 21 ticks",
          "[games][runner][arcade]") {
    const Jump held = jumpOf(stageOf(fieldOf(8), "1985"), 200), tapped = jumpOf(stageOf(fieldOf(8), "1985"), 1);
    // The tables give the apex in whole pixels, rounded up. Here only the position in the world is rounded, by 1e-15 of
    // a few metres.
    CHECK(held.pixels == Approx(66).margin(1e-9));
    CHECK(std::ceil(tapped.pixels) == 24);
    CHECK(tapped.pixels == Approx(apexOfTables(4, 0x20, 0x70, 1) / 256.0).margin(1e-9));
    CHECK(held.ticks == 53);
    CHECK(tapped.ticks == 21);
}

TEST_CASE("by the tables of 1985 a walking jump has the gravity 1Eh, and a running jump 28h",
          "[games][runner][arcade]") {
    // Walking reaches 1.5 px per tick after 41 ticks, running 2.5 after 45: above the limits of the speed bands, 1 and
    // 1.5625.
    const Jump walking = jumpOf(stageOf(fieldOf(40), "1985"), 200, 60, {.move = 1});
    const Jump running = jumpOf(stageOf(fieldOf(40), "1985"), 200, 60, {.move = 1, .run = true});
    CHECK(walking.pixels == Approx(apexOfTables(4, 0x1E, 0x60, 200) / 256.0).margin(1e-9));
    CHECK(running.pixels == Approx(apexOfTables(5, 0x28, 0x90, 200) / 256.0).margin(1e-9));
    CHECK(std::ceil(walking.pixels) == 71);
    CHECK(std::ceil(running.pixels) == 83);
}

TEST_CASE("a held modern jump rises 4.3 m, and an earlier release makes it lower", "[games][runner]") {
    const double held = jumpOf(stageOf(fieldOf(8)), 200).pixels / 16, dt = 1.0 / 60;
    // The highest point at whole ticks is below the apex by at most the fall of one tick.
    CHECK(held <= 4.3 + 1e-9);
    CHECK(held >= 4.3 - feelOf("modern").profile.vertical.jumps[0].riseGravity * dt * dt / 2);
    CHECK(jumpOf(stageOf(fieldOf(8)), 1).pixels < jumpOf(stageOf(fieldOf(8)), 8).pixels - 8);
    CHECK(jumpOf(stageOf(fieldOf(8)), 8).pixels / 16 < held - 0.5);
}

TEST_CASE("a hero that falls on a snuffer stomps it and is unhurt, a hero that walks into one is hurt",
          "[games][runner]") {
    for (const std::string profile : {"1985", "modern"}) {
        INFO(profile);
        // The snuffer is between walls 2 m apart; the hero falls onto it.
        Stage stage = stageOf(".S....\n......\n......\n#..#..\n#w.#.G\n######\n", profile);
        CHECK(play(stage, 90, stand, EventKind::Stomped) == 1);
        CHECK_FALSE(stage.walkers()[0].alive);
        CHECK(stage.hero().tall);
        Stage other = stageOf("......\n......\nS.w#.G\n######\n", profile);
        CHECK(play(
                  other, 120, [](int) { return PlatformInput{.move = 1}; }, EventKind::Hurt) == 1);
        CHECK_FALSE(other.hero().tall);
        CHECK(other.hero().alive);
    }
}

TEST_CASE("a burr hurts a hero from above, and the second hurt kills the hero", "[games][runner]") {
    Stage stage = stageOf(".S....\n......\n......\n#..#..\n#u.#.G\n######\n");
    CHECK(play(stage, 600, stand, EventKind::Hurt) == 1);
    CHECK_FALSE(stage.hero().alive);
    CHECK(stage.walkers()[0].alive);
}

TEST_CASE("a spring throws the hero 7.2 m up in both profiles, with jump held or not", "[games][runner]") {
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
            // From the spring's top at 1.5 m, plus a skin. By the tables the apex is higher by v / 2 of a tick: 0.17 m.
            const double from = 1.5 + heroHalf.y();
            CHECK(highest - from > 7.2 - 0.01);
            CHECK(highest - from < 7.2 + (profile == "1985" ? 0.2 : 0.02));
        }
}

TEST_CASE("in both profiles the hero can push a crate and stand on it", "[games][runner]") {
    for (const std::string profile : {"1985", "modern"}) {
        INFO(profile);
        Stage stage = stageOf("..........\n..........\nS.x......G\n##########\n", profile);
        play(stage, 60, [](int) { return PlatformInput{.move = 1}; });
        const BodyId crate = stage.crates()[0].body;
        CHECK(stage.world().body(crate).position().x() > 3);
        CHECK(stage.heroAt().x() < stage.world().body(crate).position().x());
        play(stage, 60, stand);
        play(stage, 120, [&](int tick) {
            const double away = stage.world().body(crate).position().x() - stage.heroAt().x();
            return PlatformInput{.move = std::clamp(4 * away, -1.0, 1.0), .jump = tick < 20};
        });
        // The crate's top is at 1 + 2 x 0.48, the hero's centre 0.45 above it; each contact has a skin.
        CHECK(stage.heroAt().y() == Approx(1 + 2 * crateHalf + heroHalf.y()).margin(0.02));
    }
}

TEST_CASE("a crate that falls on a snuffer squashes it", "[games][runner]") {
    // The hero pushes the crate over the edge into a pit 1 m wide.
    Stage stage = stageOf("......\nS.x..G\n###.##\n###.##\n###.##\n###w##\n######\n");
    const auto push = [&](int) {
        const bool slidesIn = stage.world().body(stage.crates()[0].body).position().y() < 5;
        return PlatformInput{.move = slidesIn ? 0 : 0.6};
    };
    CHECK(play(stage, 150, push, EventKind::Squashed) == 1);
    CHECK_FALSE(stage.walkers()[0].alive);
}

TEST_CASE("a dead hero starts again at the last lit lantern, and taken things stay taken", "[games][runner]") {
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

TEST_CASE("a jump over a lantern lights it, a walk below it does not", "[games][runner]") {
    Stage below = stageOf("....C....\n...===...\n.........\nS.......G\n#########\n");
    Stage leap = stageOf(".............\n.............\n.............\nS.........C.G\n#############\n");
    for (int tick = 0; tick < 200 && leap.heroAt().x() < 10.5; ++tick) {
        CHECK((leap.heroAt().x() > 9.5 || !leap.lanterns()[0].lit));
        leap.update({.move = 1, .run = true, .jump = leap.heroAt().x() > 7});
    }
    // The middle of the lantern's cell is at 1.5 m; the hero is at least 2.5 m above it.
    CHECK(leap.heroAt().y() > 4);
    CHECK(leap.lanterns()[0].lit);
    CHECK(play(
              below, 120, [](int) { return PlatformInput{.move = 1}; }, EventKind::LanternLit) == 0);
}

TEST_CASE("a bump from below breaks a brick, and lights a lamp once", "[games][runner]") {
    Stage stage = stageOf("b..\n...\n...\nS.G\n###\n");
    CHECK(play(
              stage, 60, [](int tick) { return PlatformInput{.jump = tick > 10}; }, EventKind::BrickBroke) == 1);
    CHECK(isEmpty(stage.tiles().at({0, 4})));
    Stage other = stageOf("?..\n...\n...\nS.G\n###\n");
    CHECK(play(
              other, 240, [](int tick) { return PlatformInput{.jump = tick % 60 > 10}; }, EventKind::LampLit) == 1);
}

TEST_CASE("a lamp bumped from below squashes a walker on it, but not a walker on a lamp 2 m away", "[games][runner]") {
    Stage stage = stageOf("###..\n#w#..\n#?#..\n.....\n.....\n.S.G.\n#####\n");
    CHECK(play(
              stage, 60, [](int tick) { return PlatformInput{.jump = tick > 10}; }, EventKind::Squashed) == 1);
    CHECK_FALSE(stage.walkers()[0].alive);
    Stage other = stageOf("...###\n...#w#\n.?.#?#\n......\n......\n.S.G..\n######\n");
    CHECK(play(
              other, 60, [](int tick) { return PlatformInput{.jump = tick > 10}; }, EventKind::Squashed) == 0);
    CHECK(other.walkers()[0].alive);
}

TEST_CASE("thorns hurt a hero that stands on them, and throw it 1.6 m up", "[games][runner]") {
    Stage stage = stageOf("....\n....\n....\nS..G\n^^##\n####\n");
    double highest = 0;
    const auto away = [&](int) {
        highest = std::max(highest, stage.heroAt().y());
        return PlatformInput{.move = 1};
    };
    CHECK(play(stage, 60, away, EventKind::Hurt) == 1);
    // From the thorns' top at 2 m; whole ticks miss the apex by a little, and the hero keeps a skin.
    CHECK(highest == Approx(2 + heroHalf.y() + 1.6).margin(0.02));
    CHECK(stage.hero().alive);
    CHECK(stage.heroAt().x() > 2);
}

TEST_CASE("a lift carries the hero to and fro, to a billionth of a metre", "[games][runner]") {
    // The lift is under the start, wherever on its path it begins.
    Stage stage = stageOf(".....S...G\n.ppppp--..\n..........\n");
    play(stage, 30, stand);
    REQUIRE(stage.hero().mover.slide().isOnFloor);
    const auto lift = [&] { return stage.world().body(stage.lifts()[0].body).position().x(); };
    const double onLift = stage.heroAt().x() - lift();
    double least = lift(), most = lift();
    for (int tick = 0; tick < 300; ++tick) {
        stage.update({});
        least = std::min(least, lift());
        most = std::max(most, lift());
        CHECK(stage.heroAt().x() - lift() == Approx(onLift).margin(1e-9));
    }
    // Its path is from 3.5 m to 7.5 m, at 4 m/s.
    CHECK(least < 3.6);
    CHECK(most > 7.4);
}
