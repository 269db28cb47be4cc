// SPDX-License-Identifier: MIT
#include <plumb/movers/arcade_profile.h>

#include <cmath>
#include <vector>

#include "catch.h"

namespace {

using namespace plumb;

struct WaveRow {
    int level;
    std::vector<double> seconds;
};

/// Scatter and chase by turns; the eighth is without end.
const std::vector<WaveRow> waveRows{{1, {7, 20, 7, 20, 5, 20, 5}},
                                    {2, {7, 20, 7, 20, 5, 1033, 1 / 60.0}},
                                    {4, {7, 20, 7, 20, 5, 1033, 1 / 60.0}},
                                    {5, {5, 20, 5, 20, 5, 1037, 1 / 60.0}},
                                    {99, {5, 20, 5, 20, 5, 1037, 1 / 60.0}}};

}  // namespace

TEST_CASE("hunters scatter and chase by the table, up to a microsecond before and from each change on", "[arcade]") {
    for (const WaveRow& row : waveRows) {
        const ArcadeWaves waves = arcadeWaves(row.level);
        CHECK(std::isinf(waves.times[7]));
        double change = 0;
        CHECK(modeAt(waves, 0) == HunterMode::Scatter);
        for (std::size_t wave = 0; wave < row.seconds.size(); ++wave) {
            CAPTURE(row.level, wave);
            CHECK(waves.times[wave] == row.seconds[wave]);
            change += row.seconds[wave];
            const bool scatters = wave % 2 == 0;
            CHECK(modeAt(waves, change - 1e-6) == (scatters ? HunterMode::Scatter : HunterMode::Chase));
            CHECK(modeAt(waves, change) == (scatters ? HunterMode::Chase : HunterMode::Scatter));
        }
        CHECK(modeAt(waves, 1e9) == HunterMode::Chase);
    }
    // 7 + 20 + 7 + 20 + 5 + 20 + 5 s, and 7 + 20 + 7 + 20 + 5 + 1033 s and a 60th.
    CHECK(modeAt(arcadeWaves(1), 83.9) == HunterMode::Scatter);
    CHECK(modeAt(arcadeWaves(1), 84.1) == HunterMode::Chase);
    CHECK(modeAt(arcadeWaves(2), 1092.01) == HunterMode::Scatter);
}

TEST_CASE("fright lasts 6, 5, 4, 3, 2, 5, 2, 2, 1, 5, 2, 1, 1, 3, 1, 1, 0, 1 s and then none, with 5 flashes or 3",
          "[arcade]") {
    const std::vector<int> seconds{6, 5, 4, 3, 2, 5, 2, 2, 1, 5, 2, 1, 1, 3, 1, 1, 0, 1, 0, 0, 0};
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        const ArcadeFright fright = arcadeFright(static_cast<int>(i) + 1);
        CAPTURE(i + 1);
        CHECK(fright.time == seconds[i]);
        CHECK(fright.flashes == (seconds[i] == 0 ? 0 : seconds[i] == 1 ? 3 : 5));
    }
    CHECK(arcadeFright(256).time == 0);
}

TEST_CASE("haste begins at 20, 30, 40 x3, 50 x3, 60 x3, 80 x3, 100 x4 and 120 dots left", "[arcade]") {
    const std::vector<int> dots{20, 30, 40, 40, 40, 50, 50, 50, 60, 60, 60, 80, 80, 80, 100, 100, 100, 100, 120, 120};
    for (std::size_t i = 0; i < dots.size(); ++i) CHECK(arcadeHasteDots(static_cast<int>(i) + 1) == dots[i]);
    CHECK(arcadeHasteDots(256) == 120);
}

TEST_CASE("the house lets hunters out after 0, 30, 60 dots on level 1, 0, 0, 50 on 2, or 4 s without one, 3 s from 5",
          "[arcade]") {
    CHECK(arcadeHouse(1).limits == std::array{0, 30, 60});
    CHECK(arcadeHouse(2).limits == std::array{0, 0, 50});
    for (int level = 3; level <= 256; ++level) CHECK(arcadeHouse(level).limits == std::array{0, 0, 0});
    for (int level = 1; level <= 256; ++level) CHECK(arcadeHouse(level).noDotTime == (level < 5 ? 4 : 3));
    CHECK(ArcadeProfile{}.houseLimitsAfterDeath == std::array{7, 17, 32});
}

TEST_CASE("240 dots and 4 energizers make 244 to eat, on 28 x 36 tiles of 8 pixels: 224 x 288", "[arcade]") {
    const ArcadeProfile arcade;
    CHECK(arcade.dots + arcade.energizers == 244);
    CHECK(arcade.columns * arcade.pixelsPerTile == 224);
    CHECK(arcade.rows * arcade.pixelsPerTile == 288);
    CHECK(arcade.fruitAfter == std::array{70, 170});
}

TEST_CASE("a level of 0 and a time of -1 s or none are refused", "[arcade]") {
    for (const int level : {0, -1}) {
        CHECK_THROWS_WITH(arcadeSpeeds(level), "level: " + std::to_string(level) + " is not a level, 1 or more");
        CHECK_THROWS_AS(arcadeFright(level), std::invalid_argument);
        CHECK_THROWS_AS(arcadeWaves(level), std::invalid_argument);
        CHECK_THROWS_AS(arcadeHouse(level), std::invalid_argument);
        CHECK_THROWS_AS(arcadeHasteDots(level), std::invalid_argument);
    }
    CHECK_THROWS_AS(modeAt(arcadeWaves(1), -1), std::invalid_argument);
    CHECK_THROWS_AS(modeAt(arcadeWaves(1), std::nan("")), std::invalid_argument);
}
