// SPDX-License-Identifier: MIT
#include <plumb/shapes/tile_text.h>

#include <algorithm>

#include <plumb/math/check.h>

namespace plumb {

namespace {

Tile tileOf(char letter, const TileLegend& legend, std::size_t row, std::size_t column) {
    const auto found = legend.find(letter);
    if (found != legend.end()) return found->second;
    std::string known;
    for (const auto& [sign, tile] : legend) known += std::string(known.empty() ? "" : ", ") + "'" + sign + "'";
    refuse("tileMapOf: rows[" + std::to_string(row) + "][" + std::to_string(column) + "]",
           std::string("'") + letter + "' stands for no tile; known are " + known);
}

char letterOf(const Tile& tile, const TileLegend& legend) {
    const auto found =
        std::find_if(legend.rbegin(), legend.rend(), [&](const auto& entry) { return entry.second == tile; });
    if (found != legend.rend()) return found->first;
    refuse("textOf: legend", "has no letter for a tile of the map");
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.emplace_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

}  // namespace

TileLegend standardLegend() {
    const auto solid = [](TileForm form) { return Tile{.form = form}; };
    const auto full = [](TileKind kind) { return Tile{.form = TileForm::Full, .kind = kind}; };
    return {{' ', {}},
            {'.', {}},
            {'#', full(TileKind::Solid)},
            {'=', full(TileKind::OneWay)},
            {'^', full(TileKind::Hazard)},
            {'~', full(TileKind::Sensor)},
            {'/', solid(TileForm::SlopeUp)},
            {'\\', solid(TileForm::SlopeDown)},
            {'1', solid(TileForm::GentleUpLow)},
            {'2', solid(TileForm::GentleUpHigh)},
            {'3', solid(TileForm::GentleDownHigh)},
            {'4', solid(TileForm::GentleDownLow)}};
}

TileMap tileMapOf(std::span<const std::string> rows, double size, const TileLegend& legend) {
    std::size_t columns = 0;
    for (const std::string& row : rows) columns = std::max(columns, row.size());
    if (columns == 0) refuse("tileMapOf: rows", "hold no cell");
    TileMap map({.columns = static_cast<int>(columns), .rows = static_cast<int>(rows.size()), .size = size});
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].size(); ++column)
            map.set({static_cast<int>(column), static_cast<int>(rows.size() - 1 - row)},
                    tileOf(rows[row][column], legend, row, column));
    return map;
}

TileMap tileMapOf(std::initializer_list<std::string> rows, double size, const TileLegend& legend) {
    return tileMapOf(std::span(rows.begin(), rows.size()), size, legend);
}

TileMap tileMapOf(std::string_view text, double size, const TileLegend& legend) {
    return tileMapOf(linesOf(text), size, legend);
}

std::vector<std::string> textOf(const TileMap& map, const TileLegend& legend) {
    std::vector<std::string> rows;
    for (int row = map.rows() - 1; row >= 0; --row) {
        std::string text;
        for (int column = 0; column < map.columns(); ++column) text += letterOf(map.at({column, row}), legend);
        rows.push_back(text);
    }
    return rows;
}

}  // namespace plumb
