// SPDX-License-Identifier: MIT
#include <deque>
#include <filesystem>
#include <fstream>

#include <games/frame/record.h>
#include <games/runner/buttons.h>
#include <games/runner/computer.h>
#include <games/runner/level_text.h>
#include <games/runner/levels.h>
#include <games/runner/runner.h>
#include <games/runner/way_search.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::runner;

namespace {

GameSetup setupOf(std::uint64_t seed, const std::string& profile, const std::string& from = "1") {
    return {seed, {{"profile", profile}, {"from", from}, {"level", ""}}};
}

/// Plays a level as the computer does; returns the stage at the end.
Stage finish(const LevelText& text, std::uint64_t seed, const std::string& profile) {
    const auto level = std::make_shared<const Level>(readLevel(text.text, text.file));
    const WayField field(*level);
    Stage stage(level, {profile, seed});
    std::deque<Buttons> way;
    Buttons last = 0;
    while (!stage.isOver() && stage.ticks() < 60 * 120) {
        if (way.empty()) {
            const std::vector<Buttons> found = findWay(stage, last, field);
            way.assign(found.begin(), found.end());
        }
        last = way.front();
        way.pop_front();
        stage.update(platformInput(last));
    }
    return stage;
}

}  // namespace

TEST_CASE("each level can be finished within two minutes, in both profiles", "[games][runner][slow]") {
    for (const LevelText& level : builtInLevels())
        for (const std::string profile : {"modern", "1985"}) {
            INFO(level.file << ' ' << profile);
            CHECK(finish(level, 3, profile).isFinished());
        }
}

TEST_CASE("a copy of a stage continues like the original to the last bit", "[games][runner]") {
    const auto level = std::make_shared<const Level>(readLevel(builtInLevels()[0].text, "1"));
    Stage stage(level, {"modern", 5});
    const auto input = [](int tick) {
        return PlatformInput{.move = tick % 90 < 70 ? 1.0 : -1.0, .run = true, .jump = tick % 50 < 20};
    };
    for (int tick = 0; tick < 200; ++tick) stage.update(input(tick));
    Stage copy = stage;
    for (int tick = 200; tick < 500; ++tick) {
        stage.update(input(tick));
        copy.update(input(tick));
    }
    CHECK(stage.hash() == copy.hash());
}

TEST_CASE("the same seed and buttons give the same hash, another seed gives another hash", "[games][runner]") {
    const auto hashOf = [](std::uint64_t seed) {
        const ActionList actions(runner::actions());
        Runner runner(setupOf(seed, "modern"));
        Buttons before = 0;
        for (int tick = 0; tick < 600; ++tick) {
            const Buttons now = rightButton | runButton | (tick % 45 < 15 ? jumpButton : 0);
            runner.update(Input(actions, now, before));
            before = now;
        }
        return runner.hash();
    };
    CHECK(hashOf(1) == hashOf(1));
    CHECK(hashOf(1) != hashOf(2));
}

TEST_CASE("each walk into the water costs one of four lives, and the game ends at 0", "[games][runner]") {
    const std::string file = (std::filesystem::temp_directory_path() / "plumb_runner_pool.txt").string();
    std::ofstream(file) << "map:\n.......\nS.....G\n##~~~##\n";
    const ActionList actions(runner::actions());
    Runner runner({1, {{"profile", "modern"}, {"from", "1"}, {"level", file}}});
    std::vector<int> lives{runner.lives()};
    for (int tick = 0; tick < 60 * 60 && runner.progress().outcome == Outcome::Running; ++tick) {
        runner.update(Input(actions, rightButton, 0));
        if (runner.lives() != lives.back()) lives.push_back(runner.lives());
    }
    std::filesystem::remove(file);
    CHECK(lives == std::vector<int>{4, 3, 2, 1, 0});
    CHECK(runner.progress().outcome == Outcome::Lost);
}
