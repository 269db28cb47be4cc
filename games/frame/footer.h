// SPDX-License-Identifier: MIT
// How are lines of text shown below the picture, so that they hide no part of it?
#pragma once
#include <string>
#include <vector>

#include <games/frame/canvas.h>
#include <games/frame/game.h>

namespace plumb::games {

/// A line of columns, all of the same width.
using FooterLine = std::vector<std::string>;

/// Draws a strip at the window's lower edge, as high as its lines. The picture, which is drawn after this, becomes
/// lower by that height. Without lines there is no strip.
void drawFooter(Canvas& canvas, const std::vector<FooterLine>& lines, const Theme& theme);

}  // namespace plumb::games
