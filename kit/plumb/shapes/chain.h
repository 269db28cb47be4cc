// SPDX-License-Identifier: MIT
// Of which convex pieces does a shape consist for collision tests?
#pragma once
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Does it consist of more than one piece, or, if it is an empty tile map, of none?
bool hasPieces(const Shape& shape);

/// The segments of a chain in order, each with its neighbours; the areas of a tile map's solid and one-way tiles; any
/// other shape is its own single piece. Throws std::invalid_argument if a chain has too few points.
std::vector<Shape> piecesOf(const Shape& shape);

}  // namespace plumb
