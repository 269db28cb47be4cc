// SPDX-License-Identifier: MIT
// Which one-way shapes and tiles form one floor, which is passed as a whole?
#pragma once
#include <optional>

#include <plumb/movers/slide.h>

namespace plumb::detail {

/// The direction, in the world, from which alone the hit shape or tile is solid; empty when it is solid from all sides.
std::optional<Vec2> openSideOf(const CastHit& hit);

/// nullptr when the shape was removed, or is not a tile map any more.
const TileMap* mapOf(const World& world, const ShapeId& shape);

/// A one-way shape is one floor; one-way tiles of a map form one floor if their tops join end to end, horizontally.
bool isOneFloor(const World& world, const OneWayFloor& a, const OneWayFloor& b);

}  // namespace plumb::detail
