// SPDX-License-Identifier: MIT
#include <compare/scene/random/rows.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::compare {
namespace {

/// The place of an item; it is larger than the item by the gap.
struct Cell {
    Vec2 lower{0, 0}, size{0, 0};  ///< lower is counted from the row's lower left corner [m]
    std::size_t column = 0;
};

/// Columns of items side by side. In a column small items stand on each other; it is as wide as its lowest item.
struct Row {
    std::vector<Cell> cells{};
    double width = 0, height = 0;  ///< [m]
    Extent extent{};
};

/// On the last cell if there is room, else in a new column.
Cell nextCell(const Row& row, const Vec2& size) {
    if (row.cells.empty()) return {.size = size};
    const Cell& last = row.cells.back();
    const double above = last.lower.y() + last.size.y();
    if (size.x() <= last.size.x() && above + size.y() <= row.height)
        return {{last.lower.x(), above}, size, last.column};
    return {{row.width, 0}, size, last.column + 1};
}

/// A row with as many items as there is room for; empty if there is no room for one.
Row longestRow(const std::vector<Item>& items, std::size_t first, double low, const Rows& rows) {
    Row row;
    for (std::size_t i = first; i < items.size(); ++i) {
        const Cell cell = nextCell(row, 2 * (1 + rows.gap) * items[i].half);
        const double width = std::max(row.width, cell.lower.x() + cell.size.x());
        const double height = std::max(row.height, cell.size.y());
        const std::optional<Extent> extent = rows.extent(low, low + height);
        if (!extent || low + height > rows.top || width > extent->right - extent->left) break;
        row.cells.push_back(cell);
        row.width = width;
        row.height = height;
        row.extent = *extent;
    }
    return row;
}

/// The width that is left over is shared between the columns. Each item has a random place in its cell.
std::vector<Vec2> originsIn(const Row& row, double low, double gap, Draw& draw) {
    const double columns = static_cast<double>(row.cells.back().column + 1);
    const double spare = (row.extent.right - row.extent.left - row.width) / columns;
    std::vector<Vec2> origins;
    for (const Cell& cell : row.cells) {
        const Vec2 play = 0.45 * gap / (1 + gap) * cell.size;
        const double x = draw.uniform(-play.x(), play.x() + spare), y = draw.uniform(-play.y(), play.y());
        const Vec2 corner(row.extent.left + spare * static_cast<double>(cell.column), low);
        origins.push_back(corner + cell.lower + cell.size / 2 + Vec2(x, y));
    }
    return origins;
}

}  // namespace

Rows rowsBetween(const Extent& extent, double bottom, double gap) {
    return {.bottom = bottom,
            .top = std::numeric_limits<double>::infinity(),
            .gap = gap,
            .extent = [extent](double, double) { return extent; }};
}

std::optional<std::vector<Vec2>> placeInRows(const std::vector<Item>& items, const Rows& rows, Draw draw) {
    std::vector<Vec2> origins;
    double low = rows.bottom;
    while (origins.size() < items.size()) {
        const Row row = longestRow(items, origins.size(), low, rows);
        if (!row.cells.empty()) {
            const std::vector<Vec2> placed = originsIn(row, low, rows.gap, draw);
            origins.insert(origins.end(), placed.begin(), placed.end());
            low += row.height;
            continue;
        }
        const double height = items[origins.size()].half.y();
        if (!std::isfinite(rows.top) || low + height > rows.top) return {};
        low += height / 4;  // because a ring is wider there
    }
    return origins;
}

double areaOf(const std::vector<Item>& items) {
    double area = 0;
    for (const Item& item : items) area += 4 * item.half.x() * item.half.y();
    return area;
}

double widestOf(const std::vector<Item>& items) {
    double widest = 0;
    for (const Item& item : items) widest = std::max(widest, 2 * item.half.x());
    return widest;
}

double addItems(Scene& scene, const std::vector<Item>& items, const std::vector<Vec2>& origins) {
    double top = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        addItem(scene, items[i], origins[i]);
        top = std::max(top, origins[i].y() + items[i].half.y());
    }
    return top;
}

}  // namespace plumb::compare
