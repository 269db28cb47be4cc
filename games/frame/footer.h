// SPDX-License-Identifier: MIT
// What is told below the picture, where it lies over no part of it?
#pragma once
#include <string>
#include <vector>

#include <games/frame/canvas.h>
#include <games/frame/game.h>

namespace plumb::games {

/// A line of columns, all of one width.
using FooterLine = std::vector<std::string>;

/// A strip at the window's lower edge, as high as its lines; the picture, which is drawn after this, becomes as much
/// smaller. None without lines.
void drawFooter(Canvas& canvas, const std::vector<FooterLine>& lines, const Theme& theme);

}  // namespace plumb::games
