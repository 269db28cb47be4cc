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
    double bottom = 0, top = 0;  ///< no row begins below or ends above [m]
    double gap = 0.05;           ///< at least so much between two, as a share of an item's size [-]
    /// What a row from low to high may take; empty where there is no room.
    std::function<std::optional<Extent>(double low, double high)> extent{};
};

/// Rows of one width, as high as it takes.
Rows rowsBetween(const Extent& extent, double bottom, double gap = 0.05);

/// The items' origins, in their order; empty when there is not enough room.
std::optional<std::vector<Vec2>> placeInRows(const std::vector<Item>& items, const Rows& rows, Draw draw);

/// Those of the items together, if they stood alone in squares [m^2].
double areaOf(const std::vector<Item>& items);

/// The widest one [m].
double widestOf(const std::vector<Item>& items);

/// Adds them where they are placed, and returns the top of the highest [m].
double addItems(Scene& scene, const std::vector<Item>& items, const std::vector<Vec2>& origins);

}  // namespace plumb::compare
