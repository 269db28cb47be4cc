// SPDX-License-Identifier: MIT
// Which direction does a hunter take at a crossing?
#pragma once
#include <optional>

#include <plumb/movers/grid_pass.h>

namespace plumb {

struct GridCrossing {
    Cell cell = {};                        ///< where to choose
    Direction heading = Direction::Right;  ///< on entering the cell; the exit is never its opposite
    GridPass pass = {};
    bool upClosed = false;  ///< the arcade's map has four cells that hunters do not leave upward
};

/// The exit whose next cell is nearest to the target, in a straight line; of equals, up before left before down before
/// right. None in a dead end. An arcade hunter chooses one tile ahead: on entering a tile it decides for the next one.
/// Distances are measured on the map as drawn, not across its wrapped edges.
/// Source: The Pac-Man Dossier, chapter 4. Test: "a hunter's choice is the best of all exits in 100,000 crossings ..."
std::optional<Direction> nextDirection(const TileMap& map, const GridCrossing& crossing, Cell target);

/// The wanted exit if it is open and not the reverse, otherwise the first open one, clockwise; none in a dead end. A
/// frightened hunter of the arcade wants a random one. Source: the same.
std::optional<Direction> firstOpenClockwise(const TileMap& map, const GridCrossing& crossing, Direction wanted);

}  // namespace plumb
