// SPDX-License-Identifier: MIT
// Which smooth outlines do the walls have?
#pragma once
#include <vector>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {

using Outline = std::vector<Vec2>;  ///< closed [tiles]

/// Walls are thinner than their tiles, with round corners.
struct Hedges {
    std::vector<Outline> islands;  ///< counter-clockwise round the walls between lanes
    std::vector<Outline> lawns;    ///< clockwise round all lanes, beyond the tunnel's ends too
};

/// Drawn back by an inset from the lanes' edges, 0 to 1; radius of corners, up to half of what is left [tiles].
Hedges hedgesOf(double inset, double radius);

/// The maze with its rim; beside it stands what players are told [tiles].
inline const Vec2 gardenCorner{-0.36, 1}, gardenSize{28.72, 33};

/// What the maze is on; the rim is lighter the higher flash is, 0 to 1.
void drawGarden(Canvas& canvas, const GardenLook& look, double flash);

}  // namespace plumb::games::maze
