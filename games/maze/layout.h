// SPDX-License-Identifier: MIT
// Where are the lanes, the dots, the house and the start positions?
#pragma once
#include <plumb/movers/arcade_maze.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::games::maze {

/// What a tile is besides wall or lane: bits of Tile.tag.
enum TileTag : std::uint32_t {
    dotTag = 1,
    powerTag = 2,
    houseTag = 4,  ///< solid for all that move in lanes
    doorTag = 8,
};

inline constexpr int columns = 28, rows = 36;  ///< as on the arcade's screen; the maze fills 31 rows
inline constexpr int pixelsPerTile = 8;

/// A position in pixels, from the lower left corner of the map, y up. Hunters in the house stand between tiles.
struct Pixel {
    int x = 0, y = 0;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};
inline Vec2 tilesOf(const Pixel& pixel) {
    return Vec2(pixel.x, pixel.y) / pixelsPerTile;
}

// Both lie on the edge between two cells, in the middle of the maze.
inline const GridPlace playerStart = placeOfPixel(112, 212);
inline const GridPlace fruitPlace = placeOfPixel(112, 164);

/// The walls differ from those of the arcade. The house, the tunnel and the special tiles are in the same places, so
/// that the arcade's numbers have the same effect.
const ArcadeMaze& specialPlaces();

/// Its cells have size 1: the unit of length in this game is a tile.
const TileMap& mazeMap();

bool has(const Tile& tile, TileTag tag);
Vec2 positionOf(const GridPlace& place);  ///< [tiles]
bool isLane(Cell cell);                   ///< may the player go there?

}  // namespace plumb::games::maze
