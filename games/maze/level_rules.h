// SPDX-License-Identifier: MIT
// How fast, how long, how many, on one level?
#pragma once
#include <plumb/movers/arcade_profile.h>

namespace plumb::games::maze {

inline constexpr int framesPerSecond = 60;  ///< a tick is a frame of the arcade, whose 60.6 a second are 60 here

/// The kit's tables for a level, times in frames.
struct LevelRules {
    int level = 1;
    ArcadeSpeeds speeds{};
    ArcadeWaves waves{};
    ArcadeHouse house{};
    ArcadeFruit fruit{};
    int noDotFrames = 0;
    int hasteDots = 0;     ///< left, at which the first hunter makes haste; at half as many, more
    int frightFrames = 0;  ///< 0: hunters turn back, and that is all
    int flashes = 0;

    /// Is a frightened hunter light, so many frames before it takes heart? As often as there are flashes, at the end.
    bool isFlash(int framesLeft) const;
};

/// Throws std::invalid_argument on less than 1.
LevelRules rulesOf(int level);

int framesIn(double seconds);
/// The kit's pattern, from a table: it is asked for five times a frame.
SpeedPattern patternOf(int percent);

// What the sources leave open.
inline constexpr int houseSpeed = 40;  ///< half a pixel a frame: who comes out is seen coming [%]
inline constexpr int eyesSpeed = 160;  ///< the fastest that a pattern can be [%]

}  // namespace plumb::games::maze
