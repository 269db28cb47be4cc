// SPDX-License-Identifier: MIT
// What does each screen of a game look like?
#pragma once
#include <string>
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

/// Writes <folder>/<game>-<screen>-<width>x<height>.png for each screen: the title; a round that the computer plays,
/// after 1, 5, 20 and 60 seconds; then the debug view; the pause; the round's end, if it comes within ten minutes; the
/// best scores. Each is written at 640 x 360, 1280 x 720 and 1920 x 1080. Returns the names of the files. Throws
/// std::runtime_error when a file cannot be written.
std::vector<std::string> writePictures(const GameInfo& info, const std::string& folder);

}  // namespace plumb::games
