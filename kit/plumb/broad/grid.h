// SPDX-License-Identifier: MIT
// Which boxes overlap? Tests those in neighbouring cells of a hierarchical grid.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

struct GridSettings {
    double cellSize = 0;  ///< of the finest cells, > 0; 0: chosen from the boxes [m]
};

/// A box is in one cell, that of its lower corner, of a grid whose cells are at least twice its larger side: the finest
/// grid, or one two, four, eight, ... times as coarse. So it extends no farther than into the next cells, and is tested
/// against the boxes in its own cell and the eight around it, and in coarser grids against those around its position.
/// The cells are stored as a sorted list of the boxes, and empty cells are not stored: memory is in proportion to the
/// number of boxes, wherever they are and however large they are. Beyond 2^40 cells from the middle there is one last
/// cell.
/// The finest cells, unless given, are twice as wide as the larger side of nine of ten boxes; for boxes of nearly no
/// size, a millionth of their distance, so that cells can be counted. A box that is infinite, or whose size is not
/// finite, is in no cell and is tested against all. A test is one box tested against another. Time and tests grow in
/// proportion to n for evenly distributed boxes of about the same size; many boxes in one cell are tested each against
/// each.
/// Throws std::invalid_argument unless the cell size is finite and not negative.
/// Source: Ericson, "Real-time collision detection", 2005, 7.1 and 7.2 (hierarchical grids).
/// Test: "all broad phases find equal pairs in 1,000 scenes"
PairSearch gridPairs(std::span<const Aabb> boxes, const GridSettings& settings = {});

}  // namespace plumb
