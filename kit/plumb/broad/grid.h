// SPDX-License-Identifier: MIT
// Which boxes overlap? Asked of those in neighbouring cells of a grid.
#pragma once
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

struct GridSettings {
    double cellSize = 0;  ///< of the finest cells, > 0; 0: chosen from the boxes [m]
};

/// A box lies in one cell, that of its lower corner, of a grid whose cells are at least twice its larger side: of the
/// finest, or of one two, four, eight, ... times as coarse. So it reaches no farther than into the next cells, and is
/// tested against those in its own cell and the eight around it, and in coarser grids against those around where it
/// lies. The cells are a sorted list of the boxes, and empty ones are nowhere: memory is in proportion to the boxes,
/// wherever they lie and however large they are. Beyond 2^40 cells from the middle of the crowd there is one cell more.
/// The finest cells, unless given, are twice as wide as nine of ten boxes are at most; of boxes next to nothing, a
/// millionth of how far they lie apart, so that cells can be counted. A box without end, or of no finite size, is in no
/// cell and is tested against all. A test is one box tested against another. Time and tests grow in proportion to n for
/// boxes of about a size that lie evenly; many in one cell are tested each against each. Throws std::invalid_argument
/// unless the cell size is finite and not negative. Source: Ericson, "Real-time collision detection", 2005, 7.1 and 7.2
/// (hierarchical grids). Test: "all broad phases find equal pairs in 1,000 scenes"
PairSearch gridPairs(std::span<const Aabb> boxes, const GridSettings& settings = {});

}  // namespace plumb
