// SPDX-License-Identifier: MIT
// Which speeds and timers did the maze game of 1980 have?
#pragma once
#include <array>
#include <cstdint>

#include <plumb/movers/grid_mover.h>

namespace plumb {

/// In percent of full speed; 0 where the level has none. Eating does not change the player's speed: it pauses the
/// player (see dotStall).
struct ArcadeSpeeds {
    int player = 100, playerFright = 0;  ///< while hunters are frightened
    int hunter = 95, hunterFright = 0, hunterTunnel = 50;
    int haste1 = 100, haste2 = 105;  ///< of hunter 0, when few dots are left, and when half as many are left
};

struct ArcadeFright {
    double time = 0;  ///< 0: hunters reverse, and nothing else happens [s]
    int flashes = 0;  ///< before it ends
};

/// Times of scatter, chase, scatter ... [s]; the last chase has no end. The timer is paused during fright.
struct ArcadeWaves {
    std::array<double, 8> times = {};
};

enum class HunterMode : std::uint8_t { Scatter, Chase };

/// Of hunters 1, 2 and 3: the number of eaten dots at which each leaves the house.
struct ArcadeHouse {
    std::array<int, 3> limits = {};
    double noDotTime = 0;  ///< time without an eaten dot after which the next one leaves anyway [s]
};

/// The bonus item that appears twice a level.
struct ArcadeFruit {
    int kind = 0;  ///< 0 to 7, each with a picture of its own
    int points = 0;
};

/// Constants of all levels. A game may copy and change them. Source of all numbers here and below: Pittman, "The
/// Pac-Man Dossier", its tables; of fright times, the notes to version 1.0.27.
struct ArcadeProfile {
    double tickRate = 60.606061;  ///< [Hz]
    double fullSpeed = 1.25;      ///< 100 % [pixels a frame]
    int pixelsPerTile = 8;
    int columns = 28, rows = 36;           ///< of the screen; the maze fills rows 3 to 33 from above
    int dots = 240, energizers = 4;        ///< a level ends when all have been eaten
    int dotStall = 1, energizerStall = 3;  ///< pauses of the player [frames]
    int dotPoints = 10, energizerPoints = 50;
    std::array<int, 4> hunterPoints{200, 400, 800, 1600};  ///< for each hunter caught during one fright
    std::array<int, 2> fruitAfter{70, 170};                ///< number of eaten dots
    std::array<double, 2> fruitTime{9, 10};  ///< it stays for a time within these limits; the exact rule is unknown [s]
    std::array<int, 3> houseLimitsAfterDeath{7, 17, 32};  ///< of one counter for all three
    /// The whole tile that the player is in: 3 pixels to the left of the centre pixel, 4 to the right. The text says so
    /// for left and right, and that up and down are alike; that the 3 are below follows remakes.
    Cornering cornering{
        .up = {3.0 / 8, 4.0 / 8}, .left = {4.0 / 8, 3.0 / 8}, .down = {4.0 / 8, 3.0 / 8}, .right = {3.0 / 8, 4.0 / 8}};
};

// Each takes the level, counted from 1; throws std::invalid_argument on less.

ArcadeSpeeds arcadeSpeeds(int level);
ArcadeFright arcadeFright(int level);
ArcadeWaves arcadeWaves(int level);
ArcadeHouse arcadeHouse(int level);
ArcadeFruit arcadeFruit(int level);
/// The number of remaining dots at which hunter 0 speeds up for the first time.
int arcadeHasteDots(int level);

/// The mode of the hunters this long after the level or the life began, without fright time [s]; at a change already
/// the next mode. Throws std::invalid_argument on a time that is negative or not finite.
HunterMode modeAt(const ArcadeWaves& waves, double time);

}  // namespace plumb
