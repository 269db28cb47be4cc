// SPDX-License-Identifier: MIT
// Along which path does a platform drawn in a map move?
#pragma once
#include <span>
#include <string>
#include <string_view>

#include <games/runner/level_text.h>

namespace plumb::games::runner {

/// The rows of a map as drawn, and their place in the file.
struct DrawnMap {
    std::string_view file;
    std::span<const std::string> rows;  ///< from top to bottom
    int firstRow = 1;                   ///< its row in the file

    /// '.' outside the map.
    char at(int row, int column) const;
    /// The centre of a cell; in the lowest row it is at a height of 0.5 m [m].
    Vec2 center(int row, int column) const;
    TextPlace place(int row, int column) const { return {firstRow + row, column + 1}; }
};

/// A platform is a run of the letter p. Its middle moves along a track, which begins beside the run, or above or below
/// its middle: - goes left and right, | up and down, + round a corner. The platform moves to the track's end and back,
/// or in a loop if the track returns to it. The middle of a run with an even number of letters is between two cells, so
/// its path is half a cell to the right of the drawn track. Throws as refuse() on a platform without a track, on a
/// track without a platform, and on a track that forks.
std::vector<Platform> platformsOf(const DrawnMap& map);

}  // namespace plumb::games::runner
