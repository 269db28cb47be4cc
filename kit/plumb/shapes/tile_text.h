// SPDX-License-Identifier: MIT
// How is a tile map read from plain text?
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <plumb/shapes/tile_map.h>

namespace plumb {

/// Which character stands for which tile.
using TileLegend = std::map<char, Tile>;

/// ' ' and '.' empty, '#' full, '=' one way, '^' hazard, '~' sensor, '/' and '\' slopes of 45 degrees that rise and
/// fall to the right, '1' '2' the low and the high half of a gentle rise, '3' '4' the high and the low half of a gentle
/// fall.
TileLegend standardLegend();

/// Rows of text, the topmost first; a row shorter than the longest is empty beyond its end. size is that of a cell [m].
/// Throws std::invalid_argument on a character that is not in the legend, with its row and column, and on a map without
/// cells.
TileMap tileMapOf(std::span<const std::string> rows, double size = 1, const TileLegend& legend = standardLegend());
TileMap tileMapOf(std::initializer_list<std::string> rows, double size = 1,
                  const TileLegend& legend = standardLegend());
/// The same for one text, split into rows at line ends; an empty line at the end is ignored.
TileMap tileMapOf(std::string_view text, double size = 1, const TileLegend& legend = standardLegend());

/// Row by row, the topmost first; if several characters stand for the same tile, the last one is used: a full stop, not
/// a space. Throws std::invalid_argument on a tile that is not in the legend.
std::vector<std::string> textOf(const TileMap& map, const TileLegend& legend = standardLegend());

}  // namespace plumb
