// SPDX-License-Identifier: MIT
// What does arithmetic in double see of a shape? Its corners and edges, where they lie, and a radius around them.
#pragma once
#include <array>
#include <cstddef>

#include <plumb/collide/distance.h>
#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Corners with the edges that leave them, and a radius around all.
struct Outline {
    std::array<Vec2, maxPolygonVertices> corners, normals;
    std::size_t count = 0;  ///< of corners
    std::size_t edges = 0;  ///< as many, but for a circle: it has none
    double radius = 0;      ///< [m]

    std::size_t after(std::size_t i) const { return i + 1 < count ? i + 1 : 0; }
    Vec2 edgeFrom(std::size_t i) const { return corners[after(i)] - corners[i]; }
};

/// The shape turned as it lies in the world, its place seen from origin: numbers no larger than need be.
/// Of a chain it is empty: a chain goes piece by piece. Throws std::invalid_argument on a polygon of too few corners,
/// or too many.
Outline outlineOf(const Shape& shape, const Transform& pose, const Vec2& origin);

/// The signed distance (see distance.h) of the cores of two outlines seen from one origin, without their radii.
Distance coreDistance(const Outline& a, const Outline& b);

}  // namespace plumb
