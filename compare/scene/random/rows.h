// SPDX-License-Identifier: MIT
// Where do items start, so that none touches another?
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include <compare/scene/random/draw.h>
#include <compare/scene/random/item.h>

namespace plumb::compare {

struct Extent {
    double left = 0, right = 0;  ///< [m]
};

/// Rows from the bottom up, each as high as its highest item.
struct Rows {
    double bottom = 0, top = 0;  ///< no row begins below bottom or ends above top [m]
    double gap = 0.05;           ///< the least gap between two items, as a share of an item's size [-]
    /// The width that a row from low to high may use; empty if there is no room.
    std::function<std::optional<Extent>(double low, double high)> extent{};
};

/// Rows of one width, as many as needed.
Rows rowsBetween(const Extent& extent, double bottom, double gap = 0.05);

/// The items' origins, in the order of the items; empty if there is not enough room.
std::optional<std::vector<Vec2>> placeInRows(const std::vector<Item>& items, const Rows& rows, Draw draw);

/// The area of all items if each is alone in its rectangle [m^2].
double areaOf(const std::vector<Item>& items);

/// The widest one [m].
double widestOf(const std::vector<Item>& items);

/// Adds the items at their origins, and returns the top of the highest one [m].
double addItems(Scene& scene, const std::vector<Item>& items, const std::vector<Vec2>& origins);

}  // namespace plumb::compare
