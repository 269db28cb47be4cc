// SPDX-License-Identifier: MIT
// Which layers does a drawing have, from the lowest to the highest?
#pragma once

namespace plumb::games {

// Values for Canvas::layer(). A game uses any layer below these, and hudLayer.
inline constexpr int debugLayer = 1'000'000;  ///< the debug view of F1
inline constexpr int hudLayer = 2'000'000;    ///< information for players, so that F1 does not draw over it
inline constexpr int menuLayer = 3'000'000;
inline constexpr int footerLayer = 4'000'000;  ///< below the picture; it hides marks that reach down there

}  // namespace plumb::games
