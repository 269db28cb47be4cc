// SPDX-License-Identifier: MIT
// Where at the picture's edge is the arrow to a shell that is out of sight?
#pragma once
#include <optional>
#include <string>

#include <games/artillery/arrangement.h>
#include <games/artillery/battle.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

struct ShellMark {
    Vec2 tip{0, 0};      ///< of the arrow, in the world [m]
    Vec2 towards{0, 1};  ///< the direction to the shell, of length 1
    std::string text;    ///< such as "41 m high" or "12 m away"
};

/// None while the shell is in sight. seen: the visible part of the world; inner: where arrows may be; sea: its height.
std::optional<ShellMark> shellMarkOf(const Vec2& shell, const Aabb& seen, const Aabb& inner, double sea);

/// Draws the arrow in world units, with the current camera. at: where the shell is drawn.
void drawShellMark(Canvas& canvas, const Battle& battle, const Vec2& at, const Arrangement& arrangement);

}  // namespace plumb::games::artillery
