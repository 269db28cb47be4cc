// SPDX-License-Identifier: MIT
// Which places of a maze have special rules, and where do its hunters start and go?
#pragma once
#include <array>
#include <vector>

#include <plumb/movers/arcade_profile.h>

namespace plumb {

/// All cells from first to last, both included, in columns and rows.
struct CellBlock {
    Cell first = {}, last = {};
};

/// A point on a lane: a cell and an offset from its centre [tiles]; for GridMoverDef.
struct GridPlace {
    Cell cell = {};
    Vec2 offset{0, 0};
};

/// Data of a maze beyond its walls; a game has its own. Rows count upward, as everywhere. Hunters have the numbers 0 to
/// 3: the one that chases, the one that ambushes, the one that flanks, and the shy one.
struct ArcadeMaze {
    std::vector<CellBlock> slow;      ///< where hunters, but not the player, move at tunnel speed
    std::vector<Cell> upClosed;       ///< cells that hunters do not leave upward, except when frightened
    std::array<Cell, 4> corners;      ///< the corner to which each hunter scatters; need not be reachable
    Cell door = {};                   ///< the cell to which a caught hunter returns
    std::array<GridPlace, 4> starts;  ///< of the hunters
};

/// The maze of 1980: 28 columns, 36 rows. Source: "The Pac-Man Dossier"; the tunnel's cells and the starts are those of
/// a clone.
ArcadeMaze arcadeMaze();

bool isSlow(const ArcadeMaze& maze, Cell cell);
/// The value of GridCrossing::upClosed.
bool isUpClosed(const ArcadeMaze& maze, Cell cell, bool frightened);

/// Converts a pixel of a screen with this number of tile rows, counted from its upper left corner; the edge between two
/// cells belongs to the left and the lower one. Throws std::invalid_argument on less than one pixel per tile.
GridPlace placeOfPixel(int x, int y, const ArcadeProfile& profile = {});

/// The speed of a hunter in percent of full speed. In a tunnel, tunnel speed takes precedence over fright speed; the
/// sources do not specify that. haste: 0, 1 or 2, of hunter 0 only.
int hunterPercent(const ArcadeSpeeds& speeds, bool slow, bool frightened, int haste = 0);

struct HunterContext {
    Cell hunter = {};                      ///< its position
    Cell player = {};                      ///< the player's position
    Direction heading = Direction::Right;  ///< of the player
    Cell chaser = {};                      ///< position of hunter 0
};

/// The target cell of a hunter, 0 to 3, when it chases. 0: the player's cell; 1: four cells ahead of it; 2: the
/// chaser's cell, mirrored at the cell two ahead of the player; 3: the player's cell from a distance of eight cells,
/// its own corner nearer. "Ahead" of a player that heads up is also as far to the left: the arcade's overflow bug.
/// Throws std::invalid_argument on another hunter.
Cell hunterTarget(int hunter, const HunterContext& context, const ArcadeMaze& maze);

}  // namespace plumb
