// SPDX-License-Identifier: MIT
// Which way does a platform go that is drawn in a map?
#pragma once
#include <span>
#include <string>
#include <string_view>

#include <games/runner/level_text.h>

namespace plumb::games::runner {

/// The rows of a map as they were drawn, and where they stand in their file.
struct DrawnMap {
    std::string_view file;
    std::span<const std::string> rows;  ///< the topmost first
    int firstRow = 1;                   ///< of the file

    /// '.' outside of it.
    char at(int row, int column) const;
    /// The centre of a cell; the lowest row's is half a metre up [m].
    Vec2 center(int row, int column) const;
    TextPlace place(int row, int column) const { return {firstRow + row, column + 1}; }
};

/// A platform is a run of the letter p. Its middle goes along the track that begins beside the run, or above or below
/// its middle: - to the left and right, | up and down, + round a corner; to the track's end and back, or round and
/// round where the track comes back to it. The middle of an even run lies between two cells; so does its way, half a
/// cell to the right of what is drawn. Throws as refuse() on a platform without a track, on a track without a
/// platform, and on one that forks.
std::vector<Platform> platformsOf(const DrawnMap& map);

}  // namespace plumb::games::runner
