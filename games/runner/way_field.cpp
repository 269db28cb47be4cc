// SPDX-License-Identifier: MIT
#include <games/runner/way_search.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace plumb::games::runner {
namespace {

constexpr double noWay = 1e6;  ///< [m]

}  // namespace

bool WayField::isOpen(Cell cell) const {
    if (!tiles_.contains(cell)) return false;
    const Tile tile = tiles_.at(cell);
    return isEmpty(tile) || tile.kind == TileKind::OneWay ||
           (tile.kind == TileKind::Solid && tile.form != TileForm::Full);
}

bool WayField::isOpenBetween(Cell from, Cell to) const {
    return isOpen(to) && isOpen({from.column, to.row}) && isOpen({to.column, from.row});
}

Cell WayField::inside(Cell cell) const {
    return {std::clamp(cell.column, 0, tiles_.columns() - 1), std::clamp(cell.row, 0, tiles_.rows() - 1)};
}

WayField::WayField(const Level& level) : tiles_(level.tiles) {
    distance_.assign(static_cast<std::size_t>(tiles_.columns()) * static_cast<std::size_t>(tiles_.rows()), noWay);
    using Entry = std::pair<double, std::pair<int, int>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const Cell end = tiles_.cellAt(level.beacon);
    at(end) = 0;
    open.push({0, {end.column, end.row}});
    while (!open.empty()) {
        const auto [far, place] = open.top();
        open.pop();
        const Cell cell{place.first, place.second};
        if (far > at(cell)) continue;
        for (int across = -1; across <= 1; ++across)
            for (int up = -1; up <= 1; ++up) {
                const Cell next{cell.column + across, cell.row + up};
                if (!isOpenBetween(cell, next)) continue;
                const double there = far + (across != 0 && up != 0 ? std::sqrt(2.0) : 1.0);
                if (there >= at(next)) continue;
                at(next) = there;
                open.push({there, {next.column, next.row}});
            }
    }
}

double WayField::distance(const Vec2& from) const {
    const Cell own = inside(tiles_.cellAt(from));
    double least = noWay;
    for (int across = -1; across <= 1; ++across)
        for (int up = -1; up <= 1; ++up) {
            const Cell cell = inside({own.column + across, own.row + up});
            const Vec2 away = tiles_.centerOf(cell) - from;
            least = std::min(least, distance_[index(cell)] + std::sqrt(away.dot(away)));
        }
    return least;
}

}  // namespace plumb::games::runner
