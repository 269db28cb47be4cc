// SPDX-License-Identifier: MIT
// Which speeds, times and numbers does a level have?
#pragma once
#include <plumb/movers/arcade_profile.h>

namespace plumb::games::maze {

inline constexpr int framesPerSecond = 60;  ///< a tick is one frame of the arcade, which ran 60.6 a second

/// The kit's tables for a level, times in frames.
struct LevelRules {
    int level = 1;
    ArcadeSpeeds speeds{};
    ArcadeWaves waves{};
    ArcadeHouse house{};
    ArcadeFruit fruit{};
    int noDotFrames = 0;
    int hasteDots = 0;     ///< the chaser speeds up when this number of dots is left, and again at half of it
    int frightFrames = 0;  ///< 0: hunters only turn back
    int flashes = 0;

    /// Is a frightened hunter drawn light, this many frames before the fright ends? It ends with the flashes.
    bool isFlash(int framesLeft) const;
};

/// Throws std::invalid_argument on less than 1.
LevelRules rulesOf(int level);

int framesIn(double seconds);
/// The kit's pattern. It is stored in a table, because it is needed five times a frame.
SpeedPattern patternOf(int percent);

// The sources do not give these values.
inline constexpr int houseSpeed = 40;  ///< half a pixel a frame, so that players see a hunter come out in time [%]
inline constexpr int eyesSpeed = 160;  ///< the highest speed of a pattern [%]

}  // namespace plumb::games::maze
