// SPDX-License-Identifier: MIT
// Which way does a hunter take at a crossing?
#pragma once
#include <optional>

#include <plumb/movers/grid_pass.h>

namespace plumb {

struct GridCrossing {
    Cell cell = {};                        ///< where to choose
    Direction heading = Direction::Right;  ///< in which it will be entered; never left by its reverse
    GridPass pass = {};
    bool upClosed = false;  ///< the arcade's map has four tiles that hunters do not leave upward
};

/// The exit whose next cell is nearest to the target, in a straight line; of equals, up before left before down before
/// right. None in a dead end. The arcade's hunter asks on entering a tile, about the next one: it decides a tile ahead.
/// Distances are counted over the map as drawn, not across its wrapped edges.
/// Source: The Pac-Man Dossier, chapter 4. Test: "a hunter's choice is the best of all exits in 100,000 crossings ..."
std::optional<Direction> nextDirection(const TileMap& map, const GridCrossing& crossing, Cell target);

/// The wanted exit if it is open and no reverse, else the first that is, clockwise; none in a dead end. The arcade's
/// frightened hunter wants one at random. Source: the same.
std::optional<Direction> firstOpenClockwise(const TileMap& map, const GridCrossing& crossing, Direction wanted);

}  // namespace plumb
