// SPDX-License-Identifier: MIT
// What is to be seen behind the title?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

/// A garden by night, so many seconds after it came up: four cats after a mouse, and then the mouse after four cats.
void drawTitleShow(Canvas& canvas, double seconds);

}  // namespace plumb::games::maze
