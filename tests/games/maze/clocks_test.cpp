// SPDX-License-Identifier: MIT
// Source of all times: The Pac-Man Dossier, and the notes to its version 1.0.27.
#include <games/maze/wave_clock.h>

#include <vector>

#include "catch.h"
#include "games/maze/driven.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

/// The frames of a life at which the mode changes, up to a number of frames.
std::vector<int> changes(int level, int frames) {
    const ArcadeWaves waves = rulesOf(level).waves;
    WaveClock clock;
    std::vector<int> found;
    for (int frame = 1; frame <= frames; ++frame)
        if (clock.step(waves)) found.push_back(frame);
    return found;
}

}  // namespace

// A second has 60 frames here. S: scatter, C: chase [s].
// Level 1: S 7 C 20 S 7 C 20 S 5 C 20 S 5 C.
// Levels 2 to 4: S 7 C 20 S 7 C 20 S 5 C 1033 S 1/60 C.
// From level 5 on: S 5 C 20 S 5 C 20 S 5 C 1037 S 1/60 C.
TEST_CASE("scatter and chase alternate at the frames of the table, on levels 1, 2, 4, 5 and 21", "[games][maze]") {
    CHECK(changes(1, 100'000) == std::vector<int>{420, 1620, 2040, 3240, 3540, 4740, 5040});
    const std::vector<int> second{420, 1620, 2040, 3240, 3540, 65520, 65521};
    CHECK(changes(2, 100'000) == second);
    CHECK(changes(4, 100'000) == second);
    const std::vector<int> fifth{300, 1500, 1800, 3000, 3300, 65520, 65521};
    CHECK(changes(5, 100'000) == fifth);
    CHECK(changes(21, 100'000) == fifth);
}

TEST_CASE("fright lasts 6, 5, 4, 3, 2, 5, 2, 2, 1, 5, 2, 1, 1, 3, 1, 1, 0, 1, 0 ... s, with 5 flashes or 3",
          "[games][maze]") {
    const std::vector<int> seconds{6, 5, 4, 3, 2, 5, 2, 2, 1, 5, 2, 1, 1, 3, 1, 1, 0, 1, 0, 0, 0};
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        const LevelRules rules = rulesOf(static_cast<int>(i) + 1);
        CAPTURE(i + 1);
        CHECK(rules.frightFrames == 60 * seconds[i]);
        int flashes = 0;
        for (int left = rules.frightFrames; left > 0; --left)
            flashes += rules.isFlash(left) && !rules.isFlash(left + 1) ? 1 : 0;
        CHECK(flashes == (seconds[i] == 0 ? 0 : seconds[i] == 1 ? 3 : 5));
        CHECK_FALSE(rules.isFlash(0));
        if (seconds[i] > 0) CHECK_FALSE(rules.isFlash(1));
    }
}

TEST_CASE("level 1: fright ends 360 frames after the power dot, without frozen frames, and pauses the wave clock",
          "[games][maze]") {
    test::DrivenChase driven(1);
    const Chase& chase = driven.chase();
    int ended = 0, left = 0, waves = 0, reversed = 0;
    for (int frame = 0; frame < 20'000 && ended < 3; ++frame) {
        const bool frozen = chase.frozen();
        driven.step();
        bool power = false;
        for (const ChaseEvent& event : chase.events()) power = power || event.kind == Happening::Power;
        if (chase.playerCaught() || chase.cleared()) left = 0;
        if (power) {
            left = 360;
            waves = chase.framesOfWaves();
            ++reversed;
        }
        if (left == 0) continue;
        if (!frozen && --left == 0) ++ended;  // the frame of the dot counts too
        CHECK(chase.frightFrames() == left);
        CHECK(chase.framesOfWaves() == waves);
        if (left > 0) continue;
        for (const Hunter& hunter : chase.hunters()) CHECK_FALSE(hunter.frightened());
    }
    CHECK(ended == 3);
    CHECK(reversed >= 3);
}
