// SPDX-License-Identifier: MIT
// Which pieces collide one by one, so that together they make a shape?
#pragma once
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// A chain's segments in order, each with its neighbours; any other shape is its own one piece. Throws
/// std::invalid_argument if the chain has too few points.
std::vector<Shape> piecesOf(const Shape& shape);

}  // namespace plumb
