// SPDX-License-Identifier: MIT
// How do the hot loops see a shape? As a convex core of one or more points with a radius around it.
#pragma once
#include <array>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Circle: one point and its radius; segment: two points, radius 0; polygon: its corners, radius 0.
/// Two points make a polygon of two edges, back to back. With a radius they make a capsule, more a rounded polygon.
/// Float, relative to a centre near the shape (the body's centre of mass): as precise anywhere in the world.
struct Convex {
    std::array<Vec2f, maxPolygonVertices> vertices;  ///< counter-clockwise [m]
    std::array<Vec2f, maxPolygonVertices> normals;   ///< outward, unit, of the edge from each vertex to the next [-]
    int count = 0;
    float radius = 0;  ///< [m]
};

/// The shape as seen from center, a point of the body's frame. What is beyond count is zero.
Convex convexOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
