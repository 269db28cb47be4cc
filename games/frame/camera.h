// SPDX-License-Identifier: MIT
// Which part of the world is seen, and where on the screen?
#pragma once
#include <games/frame/drawing.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

inline constexpr double screenWidth = 640;   ///< of the safe area, in units of the screen
inline constexpr double screenHeight = 360;  ///< likewise: 16 to 9

/// The safe area, as large as the window lets it be, in its middle, shows so much of the world; the rest of a window of
/// another form shows more of it. y up.
struct Camera {
    Vec2 center{0, 0};   ///< seen in the middle of the window [m]
    double height = 10;  ///< of what the safe area shows, > 0; its width is 16/9 of that [m]
};

/// Of a camera's world, and of the screen's units: y down, (0, 0) at the upper left of the safe area.
Affine toPixels(const Camera& camera, PixelSize size);
Affine screenToPixels(PixelSize size);

/// What of them lies within the window.
Aabb visibleIn(const Affine& toPixels, PixelSize size);

}  // namespace plumb::games
