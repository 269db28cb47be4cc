// SPDX-License-Identifier: MIT
// Which places of a maze have rules of their own, and where do its hunters start and go?
#pragma once
#include <array>
#include <vector>

#include <plumb/movers/arcade_profile.h>

namespace plumb {

/// All cells from first to last, both included, in columns and rows.
struct CellBlock {
    Cell first = {}, last = {};
};

/// On a lane, by a cell and an offset from its centre [tiles]; for GridMoverDef.
struct GridPlace {
    Cell cell = {};
    Vec2 offset{0, 0};
};

/// What a map of walls does not say; a game has its own for its own maze. Rows count upward, as everywhere. Hunters are
/// told by 0 to 3: who chases, ambushes, flanks, and who is shy.
struct ArcadeMaze {
    std::vector<CellBlock> slow;      ///< where hunters, but not the player, have their tunnel speed
    std::vector<Cell> upClosed;       ///< which hunters do not leave upward, but when frightened
    std::array<Cell, 4> corners;      ///< to which each hunter scatters; no need to be reached
    Cell door = {};                   ///< to which who was caught goes back
    std::array<GridPlace, 4> starts;  ///< of the hunters
};

/// That of 1980: 28 columns, 36 rows. Source: "The Pac-Man Dossier"; the tunnel's cells and the starts are a clone's.
ArcadeMaze arcadeMaze();

bool isSlow(const ArcadeMaze& maze, Cell cell);
/// For GridCrossing::upClosed.
bool isUpClosed(const ArcadeMaze& maze, Cell cell, bool frightened);

/// A pixel of a screen of so many rows of tiles, counted from its upper left corner; the edge between two cells belongs
/// to the left and the lower one. Throws std::invalid_argument on less than a pixel a tile.
GridPlace placeOfPixel(int x, int y, const ArcadeProfile& profile = {});

/// How fast, in percent, a hunter goes there: the tunnel's speed before that of fright, of which the sources do not say
/// which it is. haste: 0, 1 or 2, of the first hunter only.
int hunterPercent(const ArcadeSpeeds& speeds, bool slow, bool frightened, int haste = 0);

struct HunterQuestion {
    Cell hunter = {};                      ///< where it is
    Cell player = {};                      ///< where the player is
    Direction heading = Direction::Right;  ///< of the player
    Cell chaser = {};                      ///< where hunter 0 is
};

/// The cell for which a hunter, 0 to 3, makes when it chases. The player's; four cells ahead of it; the chaser's,
/// mirrored at what is two cells ahead of it; the player's from eight cells off, its own corner nearer. Ahead of a
/// player that heads up is as far to the left as well: the arcade's overflow. Throws std::invalid_argument on another
/// hunter.
Cell hunterTarget(int hunter, const HunterQuestion& question, const ArcadeMaze& maze);

}  // namespace plumb
