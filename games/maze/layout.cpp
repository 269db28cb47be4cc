// SPDX-License-Identifier: MIT
#include <games/maze/layout.h>

#include <plumb/shapes/tile_text.h>

namespace plumb::games::maze {
namespace {

/// # wall, . dot, o power dot, = the house, - its door.
constexpr std::string_view text = R"(
############################
############################
############################
############################
#..........................#
#.###.####.######.####.###.#
#.###o####.######.####o###.#
#.###.####.######.####.###.#
#.......##........##.......#
#.##.##.####.##.####.##.##.#
#.##.##.####.##.####.##.##.#
#.........##.##.##.........#
##### ### ##.##.## ### #####
##### ### ## ## ## ### #####
#####                  #####
##### ### ###--### ### #####
##### ### #======# ### #####
          #======#          
###### ## #======# ## ######
###### ## ######## ## ######
######                ######
######.#####.##.#####.######
######.#####.##.#####.######
#..........................#
#.##.#######.##.#######.##.#
#.##.#######.##.#######.##.#
#.##.........  .........##.#
#o##.####.########.####.##o#
#.##.####.########.####.##.#
#............##............#
#.####.#####.##.#####.####.#
#.####.#####.##.#####.####.#
#..........................#
############################
############################
############################
)";

TileLegend legend() {
    const Tile wall{.form = TileForm::Full};
    const auto lane = [](std::uint32_t tag) { return Tile{.tag = tag}; };
    return {{'#', wall},
            {' ', lane(0)},
            {'.', lane(dotTag)},
            {'o', lane(powerTag)},
            {'=', {.form = TileForm::Full, .tag = houseTag}},
            {'-', {.form = TileForm::Full, .tag = doorTag}}};
}

}  // namespace

const TileMap& mazeMap() {
    static const TileMap map = tileMapOf(text.substr(1), 1, legend()).wrapping(true, false);
    return map;
}

const ArcadeMaze& specialPlaces() {
    static const ArcadeMaze places = arcadeMaze();
    return places;
}

bool has(const Tile& tile, TileTag tag) {
    return (tile.tag & tag) != 0;
}

Vec2 positionOf(const GridPlace& place) {
    return mazeMap().centerOf(place.cell) + place.offset;
}

bool isLane(Cell cell) {
    return mazeMap().contains(cell) && !isSolid(mazeMap().at(cell));
}

}  // namespace plumb::games::maze
