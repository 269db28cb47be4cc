// SPDX-License-Identifier: MIT
#include <compare/scene/random/rows.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::compare {
namespace {

/// Items one beside the other, first to last - 1.
struct Row {
    std::size_t first = 0, last = 0;
    double width = 0, height = 0;  ///< [m]
    Extent extent{};
};

/// As many as there is room for; none if it is not enough for one.
Row longestRow(const std::vector<Item>& items, std::size_t first, double low, const Rows& rows) {
    Row row{first, first};
    for (std::size_t i = first; i < items.size(); ++i) {
        const Vec2 size = 2 * (1 + rows.gap) * items[i].half;
        const double width = row.width + size.x(), height = std::max(row.height, size.y());
        const std::optional<Extent> extent = rows.extent(low, low + height);
        if (!extent || low + height > rows.top || width > extent->right - extent->left) break;
        row = {first, i + 1, width, height, *extent};
    }
    return row;
}

/// What is left of the width is shared out by chance, and each item hangs somewhere between floor and ceiling.
std::vector<Vec2> placeRow(const std::vector<Item>& items, const Row& row, double low, const Rows& rows, Draw& draw) {
    std::vector<Vec2> origins;
    const double spare = (row.extent.right - row.extent.left - row.width) / static_cast<double>(row.last - row.first);
    double x = row.extent.left;
    for (std::size_t i = row.first; i < row.last; ++i) {
        const Vec2 half = (1 + rows.gap) * items[i].half;
        const double shift = draw.uniform(0, spare);
        const double lift = draw.uniform(0, row.height - 2 * half.y());
        origins.push_back({x + shift + half.x(), low + lift + half.y()});
        x += spare + 2 * half.x();
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
        if (row.last > row.first) {
            const std::vector<Vec2> placed = placeRow(items, row, low, rows, draw);
            origins.insert(origins.end(), placed.begin(), placed.end());
            low += row.height;
            continue;
        }
        const double height = items[origins.size()].half.y();
        if (!std::isfinite(rows.top) || low + height > rows.top) return {};
        low += height / 4;  // a ring is wider there
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
