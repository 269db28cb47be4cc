// SPDX-License-Identifier: MIT
#include <games/runner/view.h>

#include <filesystem>
#include <fstream>

#include <games/runner/buttons.h>
#include <games/runner/draw.h>
#include <games/runner/level_text.h>
#include <games/runner/runner.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::runner;

namespace {

/// Where the candle's two feet are drawn, in its own coordinates.
std::vector<Vec2> feetOf(const Runner& runner) {
    Canvas canvas({640, 360});
    runner.draw(canvas);
    std::vector<Vec2> feet;
    for (const Mark& mark : canvas.drawing().marks) {
        const auto* ellipse = std::get_if<EllipseMark>(&mark.shape);
        if (ellipse != nullptr && mark.brush.paint.color == Color::hex(0x8a4b3c)) feet.push_back(ellipse->center);
    }
    return feet;
}

/// The drawing of the walkers at this time.
std::vector<Mark> foesOf(const Stage& stage, const View& view, double time) {
    static const PoseTrail none;
    Canvas canvas({640, 360});
    canvas.look(view.camera(1));
    drawFoes(canvas, {stage, none, view, paletteOf(stage.level().sky), time});
    return canvas.drawing().marks;
}

}  // namespace

TEST_CASE("a candle that ran to the beacon stands still when the level is won, instead of running on the spot",
          "[games][runner]") {
    const std::string file = (std::filesystem::temp_directory_path() / "plumb_runner_won.txt").string();
    std::ofstream(file) << "map:\n............\nS..........G\n############\n";
    const ActionList actions(runner::actions());
    Runner runner({1, {{"profile", "modern"}, {"from", "1"}, {"level", file}}});
    std::filesystem::remove(file);
    while (!runner.isPlaying()) runner.update(Input(actions, 0, 0));
    std::vector<Vec2> before;
    int ticks = 0, moved = 0;
    while (runner.isPlaying() && ++ticks < 600) {
        runner.update(Input(actions, rightButton, 0));
        moved += feetOf(runner) == before ? 0 : 1;
        before = feetOf(runner);
        REQUIRE(before.size() == 2);
    }
    REQUIRE(runner.stage().isFinished());
    CHECK(moved > ticks / 2);
    runner.update(Input(actions, 0, 0));  // in the tick before it was still running
    const std::vector<Vec2> standing = feetOf(runner);
    CHECK(standing[0].y() == standing[1].y());
    for (int tick = 0; tick < 120; ++tick) {
        runner.update(Input(actions, 0, 0));
        REQUIRE(feetOf(runner) == standing);
    }
}

TEST_CASE("a snuffer moves its feet while the stage runs, and holds them while it does not", "[games][runner]") {
    const std::string rows = "map:\n......\nS..w.G\n######\n";
    Stage stage(std::make_shared<const Level>(readLevel(rows, "test")), {"modern", 1});
    View view;
    view.reset(stage);
    view.update(stage);
    const std::vector<Mark> standing = foesOf(stage, view, 0);
    REQUIRE_FALSE(standing.empty());
    view.update(stage);
    CHECK(foesOf(stage, view, 0.25) == standing);
    stage.update({});
    view.update(stage);
    CHECK_FALSE(foesOf(stage, view, 0.25) == standing);
    CHECK_THAT(view.stageTime(1), Catch::Matchers::WithinAbs(tickSeconds, 1e-15));
    CHECK_THAT(view.stageTime(0.25), Catch::Matchers::WithinAbs(0.25 * tickSeconds, 1e-15));
    view.update(stage);
    CHECK(view.stageTime(0.25) == view.stageTime(1));
}
