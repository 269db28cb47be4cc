// SPDX-License-Identifier: MIT
// Which smooth outlines do the walls have?
#pragma once
#include <vector>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {

using Outline = std::vector<Vec2>;  ///< closed [tiles]

/// Walls are thinner than their tiles, with round corners.
struct Hedges {
    std::vector<Outline> islands;  ///< the walls between lanes, counter-clockwise
    std::vector<Outline> lawns;    ///< all lanes, clockwise; they go on beyond the tunnel's ends
};

/// inset: distance from the lanes' edges to the hedge, 0 to 1; radius: of the corners, at most half of the remaining
/// width [tiles].
Hedges hedgesOf(double inset, double radius);

/// The maze with its rim; the score and the other displays are beside it [tiles].
inline const Vec2 gardenCorner{-0.36, 1}, gardenSize{28.72, 33};

/// Draws lawn, hedges and house. flash: 0 to 1; higher values make the rim lighter.
void drawGarden(Canvas& canvas, const GardenLook& look, double flash);

}  // namespace plumb::games::maze
