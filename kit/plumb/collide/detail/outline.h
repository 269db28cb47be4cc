// SPDX-License-Identifier: MIT
// How is a shape represented for arithmetic in double? By its placed corners and edges, and a radius around them.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct Distance;

/// Corners with the edges that leave them, and a radius around all.
struct Outline {
    std::array<Vec2, maxPolygonVertices> corners, normals;
    std::size_t count = 0;  ///< of corners
    std::size_t edges = 0;  ///< the same number; but 0 for a circle
    double radius = 0;      ///< [m]

    std::size_t after(std::size_t i) const { return i + 1 < count ? i + 1 : 0; }
    Vec2 edgeFrom(std::size_t i) const { return corners[after(i)] - corners[i]; }
};

/// The shape rotated as it is in the world, with positions relative to origin, so that numbers stay small. Empty for a
/// chain: convert its pieces. Throws std::invalid_argument on a polygon with too few or too many corners.
Outline outlineOf(const Shape& shape, const Transform& pose, const Vec2& origin);

/// The outline, rotated about its origin and then shifted. Faster than outlineOf, which computes the normals anew.
void place(const Outline& outline, const Rot& rotation, const Vec2& shift, Outline& placed);

/// The signed distance (see distance.h) of two outlines seen from this origin, with points in the world.
Distance distance(const Outline& a, const Outline& b, const Vec2& origin);
/// The signed distance (see distance.h) of the cores of two outlines seen from one origin, without their radii.
Distance coreDistance(const Outline& a, const Outline& b);

/// In which direction does an outline that is solid on its left push, where a cast hit one of its segments?
/// The outward normal for a cast that hit a segment on its own with this normal, in the segment's frame [-]. Along the
/// segment, and at a flat or concave vertex, that is the segment's own normal; at a convex corner, any normal between
/// its own and its neighbour's. None where the segment was hit from behind, or through the neighbour at a narrow
/// concave corner, or where the hit belongs to the neighbour.
/// Test: "10,000 movers slide over flush tiles, floor and wall, as on one slab, and lose nothing"
std::optional<Vec2> outlineNormal(const Segment& segment, const Vec2& normal);

}  // namespace plumb
