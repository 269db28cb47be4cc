// SPDX-License-Identifier: MIT
// What is drawn behind the title?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

/// A garden at night, this many seconds after the title appeared: four cats chase a mouse, then the mouse chases four
/// cats.
void drawTitleShow(Canvas& canvas, double seconds);

}  // namespace plumb::games::maze
