// SPDX-License-Identifier: MIT
// Which functions that make shapes, and tell of them, does JavaScript have?
#pragma once
#include <plumb/collide/distance.h>
#include <plumb/collide/overlap.h>
#include <plumb/shapes/bounding_circle.h>
#include <plumb/shapes/decompose.h>
#include <plumb/shapes/hull.h>
#include <plumb/shapes/mass.h>
#include <plumb/shapes/oriented_box.h>
#include <plumb/shapes/tile_text.h>
#include <web/module/call.h>

namespace plumb::web {

void listShapeCalls(auto&& list) {
    list("", "circle", "radius, material?", fn<&circle>);
    list("", "capsule", "start, end, radius, material?", fn<&capsule>);
    list("", "box", "halfSize, material?",
         fn<[](const Vec2& halfSize, const Material& material) { return box(halfSize, material); }>);
    list("", "roundedBox", "halfSize, radius, material?", fn<&roundedBox>);
    list("", "polygon", "vertices, material?", fn<&polygon>);
    list("", "roundedPolygon", "vertices, radius, material?", fn<&roundedPolygon>);
    list("", "segment", "start, end, material?", fn<&segment>);
    list("", "chain", "points, material?", fn<&chain>);
    list("", "loop", "points, material?", fn<&loop>);
    list("", "tiles", "map, material?", fn<&tiles>);
    list("", "outline", "points, material?", fn<&outline>);
    list("", "hullOf", "points", fn<&hullOf>);
    list("", "convexPieces", "outline", fn<&convexPieces>);
    list("", "massOf", "shape, density", fn<[](const Shape& shape, double density) { return massOf(shape, density); }>);
    list("", "aabbOf", "shape, pose?",
         fn<[](const Shape& shape, const Transform& pose) { return aabbOf(shape, pose); }>);
    list("", "boundingCircleOf", "shape, pose?",
         fn<[](const Shape& shape, const Transform& pose) { return boundingCircleOf(shape, pose); }>);
    list("", "orientedBoxOf", "shape, pose?",
         fn<[](const Shape& shape, const Transform& pose) { return orientedBoxOf(shape, pose); }>);
    list("", "distance", "a, poseA, b, poseB",
         fn<[](const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB) {
             return distance(a, poseA, b, poseB);
         }>);
    list("", "overlap", "a, poseA, b, poseB",
         fn<[](const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB) {
             return overlap(a, poseA, b, poseB);
         }>);
    list("", "standardLegend", "", fn<&standardLegend>);
    list("", "tileMapOf", "rows, size = 1, legend?",
         fn<[](std::span<const std::string> rows, double size, const std::optional<TileLegend>& legend) {
             return tileMapOf(rows, size, legend ? *legend : standardLegend());
         }>);
    list("", "textOf", "map, legend?", fn<[](const TileMap& map, const std::optional<TileLegend>& legend) {
             return textOf(map, legend ? *legend : standardLegend());
         }>);
}

}  // namespace plumb::web
