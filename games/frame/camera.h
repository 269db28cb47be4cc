// SPDX-License-Identifier: MIT
// Which part of the world is visible, and where on the screen?
#pragma once
#include <games/frame/drawing.h>
#include <plumb/shapes/aabb.h>

namespace plumb::games {

inline constexpr double screenWidth = 640;   ///< of the safe area [units of the screen]
inline constexpr double screenHeight = 360;  ///< of the safe area, 16 to 9 [units of the screen]

/// What the safe area shows of the world; y points up. The safe area is as large as fits into the window and lies in
/// the middle of it. A window of another shape shows more of the world at two sides.
struct Camera {
    Vec2 center{0, 0};   ///< of the visible part: the middle of the window [m]
    double height = 10;  ///< of the part in the safe area, > 0; its width is 16/9 of that [m]
};

/// The maps to pixels from a camera's world, and from the units of the screen: y down, (0, 0) at the upper left of the
/// safe area.
Affine toPixels(const Camera& camera, PixelSize size);
Affine screenToPixels(PixelSize size);

/// The part of the world, or of the screen, that lies within the window.
Aabb visibleIn(const Affine& toPixels, PixelSize size);

}  // namespace plumb::games
