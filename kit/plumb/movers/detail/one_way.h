// SPDX-License-Identifier: MIT
// Which one-way things are one floor, that holds or lets through as a whole?
#pragma once
#include <optional>

#include <plumb/movers/move_and_slide.h>

namespace plumb::detail {

/// The way, in the world, from which alone what was met, a shape or a map's tile, is solid; empty when it is from all
/// sides.
std::optional<Vec2> openSideOf(const CastHit& hit);

/// nullptr when the shape is gone, or is none any more.
const TileMap* mapOf(const World& world, const ShapeId& shape);

/// A one-way shape is a floor; of a tile map's one-way tiles those are one whose tops join end to end, sideways.
bool isOneFloor(const World& world, const OneWayFloor& a, const OneWayFloor& b);

}  // namespace plumb::detail
