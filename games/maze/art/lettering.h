// SPDX-License-Identifier: MIT
// How is text drawn over the garden so that it can be read?
#pragma once
#include <string>

#include <games/frame/canvas.h>

namespace plumb::games::maze {

/// Text with its middle at this place and a dark edge around it; size in tiles. color may be faded.
void drawLettering(Canvas& canvas, const std::string& text, const Vec2& at, const Color& color, double size);

}  // namespace plumb::games::maze
