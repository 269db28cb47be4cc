// SPDX-License-Identifier: MIT
// How do the hot loops see a shape? As a convex core of one or more points with a radius around it.
#pragma once
#include <array>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Circle: one point and its radius; segment: two points, radius 0; polygon: its corners, radius 0.
/// Two points make a polygon of two edges, back to back. A radius around two or more points makes a capsule or a
/// rounded polygon. Float, relative to a centre near the shape (the body's centre of mass), so that precision does not
/// depend on the place.
struct Convex {
    std::array<Vec2f, maxPolygonVertices> vertices;  ///< counter-clockwise [m]
    std::array<Vec2f, maxPolygonVertices>
        normals;  ///< outward, unit; normals[i] is of the edge from vertices[i] on [-]
    int count = 0;
    float radius = 0;  ///< [m]
};

/// The shape as seen from center, a point of the body's frame. What is beyond count is zero.
Convex convexOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
