// SPDX-License-Identifier: MIT
// Where was a body at which time, as somebody measured or calculated it?
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb::compare {

/// Rows of one body. Those that ownTrackFrom gives are finite, and their times rise.
struct OwnTrack {
    std::string file{};           ///< where they are from, for messages
    std::string body{};           ///< empty: the scene's first dynamic body
    std::vector<double> times{};  ///< from the start of the scene [s]
    std::vector<Vec2> places{};   ///< of the body's origin at these times [m]
};

/// Reads a table: one row a line, with columns t [s], x [m] and y [m].
///   head       a first line without any number names the columns, in any order, in small or capital letters, with or
///              without units: "t", "t [s]", "time", "x/m", "y (m)". Without a head, the first three are t, x and y. A
///              column "body" names the body. Others are ignored.
///   separator  semicolons; if the first line has none, tabs; else commas; else spaces. With the first two, a number
///              may have a decimal comma. A cell may be in quotes.
///   skipped    lines that are empty or start with #, and a byte order mark.
/// Throws std::invalid_argument, "FILE:LINE: COLUMN: ..." on one line, for what is not such a table: cells that are not
/// finite numbers, times that do not rise, other units, two bodies, fewer than two rows.
OwnTrack ownTrackFrom(std::string_view csv, const std::string& file);

}  // namespace plumb::compare
