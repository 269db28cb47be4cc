// SPDX-License-Identifier: MIT
#include <games/maze/level_rules.h>

#include <algorithm>

namespace plumb::games::maze {
namespace {

constexpr int flashFrames = 2 * 14;  ///< light, then dark; shorter if the fright is too short for all flashes
constexpr std::size_t patterns = 160 / 5 + 1;

std::array<SpeedPattern, patterns> allPatterns() {
    std::array<SpeedPattern, patterns> all;
    for (std::size_t i = 0; i < patterns; ++i) all[i] = speedPattern(5 * static_cast<int>(i));
    return all;
}

}  // namespace

int framesIn(double seconds) {
    return static_cast<int>(seconds * framesPerSecond + 0.5);
}

SpeedPattern patternOf(int percent) {
    static const std::array<SpeedPattern, patterns> all = allPatterns();
    return all[static_cast<std::size_t>(percent / 5)];
}

bool LevelRules::isFlash(int framesLeft) const {
    if (flashes == 0 || framesLeft <= 0) return false;
    const int half = std::min(flashFrames, frightFrames / flashes) / 2;
    const int phase = (framesLeft - 1) / half;  // 0 is the last one, which is dark
    return phase % 2 == 1 && phase < 2 * flashes;
}

LevelRules rulesOf(int level) {
    const ArcadeFright fright = arcadeFright(level);
    LevelRules rules{.level = level,
                     .speeds = arcadeSpeeds(level),
                     .waves = arcadeWaves(level),
                     .house = arcadeHouse(level),
                     .fruit = arcadeFruit(level),
                     .hasteDots = arcadeHasteDots(level),
                     .frightFrames = framesIn(fright.time),
                     .flashes = fright.flashes};
    rules.noDotFrames = framesIn(rules.house.noDotTime);
    return rules;
}

}  // namespace plumb::games::maze
