// SPDX-License-Identifier: MIT
// What lies above what?
#pragma once

namespace plumb::games {

// Canvas::layer(). A game uses any below these, and hudLayer.
inline constexpr int debugLayer = 1'000'000;  ///< what the kit sees
inline constexpr int hudLayer = 2'000'000;    ///< what a game tells its players, so that F1 does not draw over it
inline constexpr int menuLayer = 3'000'000;
inline constexpr int footerLayer = 4'000'000;  ///< below the picture: it hides what reaches down there

}  // namespace plumb::games
