// SPDX-License-Identifier: MIT
// Which pieces collide one by one, so that together they make a shape?
#pragma once
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Is it more than one piece, or, of an empty tile map, none?
bool hasPieces(const Shape& shape);

/// A chain's segments in order, each with its neighbours; what a tile map's solid and one-way tiles fill; any other
/// shape is its own one piece. Throws std::invalid_argument if the chain has too few points.
std::vector<Shape> piecesOf(const Shape& shape);

}  // namespace plumb
