// SPDX-License-Identifier: MIT
// At which speeds, and by which clock, did the maze game of 1980 run?
#pragma once
#include <array>
#include <cstdint>

#include <plumb/movers/grid_mover.h>

namespace plumb {

/// In percent of the full speed; 0 where the level has none. What the player loses by eating is no speed but a stall.
struct ArcadeSpeeds {
    int player = 100, playerFright = 0;  ///< while hunters are frightened
    int hunter = 95, hunterFright = 0, hunterTunnel = 50;
    int haste1 = 100, haste2 = 105;  ///< of the first hunter, when few dots are left, and when half as few
};

struct ArcadeFright {
    double time = 0;  ///< 0: hunters turn back, and that is all [s]
    int flashes = 0;  ///< at its end
};

/// How long hunters scatter, chase, scatter ... [s]; the last chase has no end. The clock stands during fright.
struct ArcadeWaves {
    std::array<double, 8> times;
};

enum class HunterMode : std::uint8_t { Scatter, Chase };

/// Of the second, third and fourth hunter: dots eaten until each leaves the house.
struct ArcadeHouse {
    std::array<int, 3> limits;
    double noDotTime;  ///< without a dot eaten until the next one leaves anyway [s]
};

/// What there is to eat twice a level.
struct ArcadeFruit {
    int kind;  ///< 0 to 7, each with a picture of its own
    int points;
};

/// What is the same on all levels. A game takes what it likes, and changes what it likes in its copy. Source of all
/// numbers here and below: Pittman, "The Pac-Man Dossier", its tables; of fright times, the notes to version 1.0.27.
struct ArcadeProfile {
    double tickRate = 60.606061;  ///< [Hz]
    double fullSpeed = 1.25;      ///< 100 % [pixels a frame]
    int pixelsPerTile = 8;
    int columns = 28, rows = 36;           ///< of the screen; the maze fills rows 3 to 33 from above
    int dots = 240, energizers = 4;        ///< a level ends when all are eaten
    int dotStall = 1, energizerStall = 3;  ///< the player stands still [frames]
    int dotPoints = 10, energizerPoints = 50;
    std::array<int, 4> hunterPoints{200, 400, 800, 1600};  ///< one after the other in one fright
    std::array<int, 2> fruitAfter{70, 170};                ///< dots eaten
    std::array<double, 2> fruitTime{9, 10};  ///< it stays for some time within these, nobody knows how long [s]
    std::array<int, 3> houseLimitsAfterDeath{7, 17, 32};  ///< of one counter for all three
    /// The whole of the tile that the player is in: 3 pixels on its left of the centre pixel, 4 on its right. The text
    /// says so of left and right, and that up and down are alike; that the 3 are below is how remakes place the centre.
    Cornering cornering{
        .up = {3.0 / 8, 4.0 / 8}, .left = {4.0 / 8, 3.0 / 8}, .down = {4.0 / 8, 3.0 / 8}, .right = {3.0 / 8, 4.0 / 8}};
};

// Each by the level, counted from 1; throws std::invalid_argument on less.

ArcadeSpeeds arcadeSpeeds(int level);
ArcadeFright arcadeFright(int level);
ArcadeWaves arcadeWaves(int level);
ArcadeHouse arcadeHouse(int level);
ArcadeFruit arcadeFruit(int level);
/// Dots left at which the first hunter makes haste, for the first time.
int arcadeHasteDots(int level);

/// What hunters do this long after the level or the life began, fright not counted [s]; at a change already the next.
/// Throws std::invalid_argument on a time that is negative or not finite.
HunterMode modeAt(const ArcadeWaves& waves, double time);

}  // namespace plumb
