// SPDX-License-Identifier: MIT
// Where are the lanes, the dots, the house, and the places where all begin?
#pragma once
#include <plumb/movers/arcade_maze.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::games::maze {

/// What a tile is beyond wall or lane: bits of Tile.tag.
enum TileTag : std::uint32_t {
    dotTag = 1,
    powerTag = 2,
    houseTag = 4,  ///< solid to all who walk in lanes
    doorTag = 8,
};

inline constexpr int columns = 28, rows = 36;  ///< as the arcade's screen has them; the maze fills 31 rows of it
inline constexpr int pixelsPerTile = 8;

/// In pixels from the lower left of the map, y up: in the house, hunters stand between tiles.
struct Pixel {
    int x = 0, y = 0;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};
inline Vec2 tilesOf(const Pixel& pixel) {
    return Vec2(pixel.x, pixel.y) / pixelsPerTile;
}

// Both on the edge between two cells, in the maze's middle.
inline const GridPlace playerStart = placeOfPixel(112, 212);
inline const GridPlace fruitPlace = placeOfPixel(112, 164);

/// The walls are our own; the house, the tunnel and what is special about some tiles stand where the arcade's are, so
/// that its figures mean the same.
const ArcadeMaze& specialPlaces();

/// Its cells are of size 1: the unit of length in this game is a tile.
const TileMap& mazeMap();

bool has(const Tile& tile, TileTag tag);
Vec2 positionOf(const GridPlace& place);  ///< [tiles]
bool isLane(Cell cell);                   ///< may the player go there?

}  // namespace plumb::games::maze
