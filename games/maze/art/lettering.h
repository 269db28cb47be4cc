// SPDX-License-Identifier: MIT
// How is something written over the garden, so that it can be read there?
#pragma once
#include <string>

#include <games/frame/canvas.h>

namespace plumb::games::maze {

/// In tiles, its middle at a place, with a dark edge around it; color may be faded.
void drawLettering(Canvas& canvas, const std::string& text, const Vec2& at, const Color& color, double size);

}  // namespace plumb::games::maze
