// SPDX-License-Identifier: MIT
// Are the numbers of a definition, and of a shape's corners, within what is allowed?
#pragma once
#include <cstddef>
#include <string_view>

#include <plumb/shapes/shape.h>

namespace plumb {

struct Mass;

// Each throws std::invalid_argument with the name of the member or the field, its value and what is wanted.

void requireMass(const Mass& mass, const char* field, std::size_t index);
void requireNumbers(const TileMapDef& def);

[[noreturn]] void refuseCount(const Polygon& polygon, std::string_view field);
[[noreturn]] void refuseCount(const Chain& chain, std::string_view field);

// Cheap enough for hot loops. Other faults that validate() finds give wrong results, but no access outside of an array.

/// Unless there are 3 to maxPolygonVertices corners.
inline void requireCount(const Polygon& polygon, std::string_view field = "Polygon") {
    const std::size_t count = polygon.vertices.size();
    if (count < 3 || count > static_cast<std::size_t>(maxPolygonVertices)) refuseCount(polygon, field);
}

/// Unless there are 2 points, or 3 if it is closed.
inline void requireCount(const Chain& chain, std::string_view field = "Chain") {
    if (chain.points.size() < (chain.closed ? 3u : 2u)) refuseCount(chain, field);
}

}  // namespace plumb
