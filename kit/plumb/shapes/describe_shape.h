// SPDX-License-Identifier: MIT
// What is each member of a shape, and what may it hold?
#pragma once
#include <plumb/math/member.h>
#include <plumb/shapes/mass.h>
#include <plumb/shapes/shape.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

template <>
inline constexpr DefinitionName definitionName<Circle>{"Circle", "circle"};
void describe(OrConst<Circle> auto& def, auto&& visit) {
    visit({"radius", "m", Allowed::positive, "from the centre to the outline"}, def.radius);
    visit({"center", "m", Allowed::finite, "in the body's frame"}, def.center);
}

template <>
inline constexpr DefinitionName definitionName<Capsule>{"Capsule", "capsule"};
void describe(OrConst<Capsule> auto& def, auto&& visit) {
    visit({"start", "m", Allowed::finite, "of the line in its middle, in the body's frame"}, def.start);
    visit({"end", "m", Allowed::finite, "of that line; not equal to start"}, def.end);
    visit({"radius", "m", Allowed::positive, "from the line to the outline"}, def.radius);
}

template <>
inline constexpr DefinitionName definitionName<Polygon>{"Polygon", "polygon"};
void describe(OrConst<Polygon> auto& def, auto&& visit) {
    visit({"vertices", "m", Allowed::finite, "3 to 64 corners, convex and counter-clockwise, in the body's frame"},
          def.vertices);
    visit({"radius", "m", Allowed::notNegative, "the outline lies so far outside of the corners and edges"},
          def.radius);
}

template <>
inline constexpr DefinitionName definitionName<Segment>{"Segment", "segment"};
void describe(OrConst<Segment> auto& def, auto&& visit) {
    visit({"start", "m", Allowed::finite, "in the body's frame"}, def.start);
    visit({"end", "m", Allowed::finite, "not equal to start"}, def.end);
    visit({"before", "m", Allowed::finite, "the point from which the line comes to start"}, def.before);
    visit({"after", "m", Allowed::finite, "the point to which the line goes on from end"}, def.after);
}

template <>
inline constexpr DefinitionName definitionName<Chain>{"Chain", "chain"};
void describe(OrConst<Chain> auto& def, auto&& visit) {
    visit({"points", "m", Allowed::finite, "2 or more, 3 or more if closed; no two in succession equal"}, def.points);
    visit({"closed", "", Allowed::any, "does the line go on from its last point to its first?"}, def.closed);
}

/// A map is made from a TileMapDef, which is described, and filled after that.
template <>
inline constexpr DefinitionName definitionName<TileMap>{"TileMap", "tiles"};

template <>
inline constexpr DefinitionName definitionName<TileMapDef>{"TileMapDef"};
void describe(OrConst<TileMapDef> auto& def, auto&& visit) {
    visit({"columns", "-", Allowed::within(1, maxTileCells), "how many cells wide it is"}, def.columns);
    visit({"rows", "-", Allowed::within(1, maxTileCells), "how many cells high it is"}, def.rows);
    visit({"size", "m", Allowed::positive, "of a cell"}, def.size);
    visit({"wrapX", "", Allowed::any, "does it go on at its left beyond its right edge?"}, def.wrapX);
    visit({"wrapY", "", Allowed::any, "does it go on at its bottom beyond its top?"}, def.wrapY);
}

template <>
inline constexpr DefinitionName definitionName<Mass>{"Mass"};
void describe(OrConst<Mass> auto& def, auto&& visit) {
    visit({"mass", "kg", Allowed::notNegative, "of the whole; a dynamic body's is positive"}, def.mass);
    visit({"center", "m", Allowed::finite, "the centre of mass, in the body's frame"}, def.center);
    visit({"inertia", "kg m^2", Allowed::notNegative, "about the centre of mass; a dynamic body's is positive"},
          def.inertia);
}

}  // namespace plumb
