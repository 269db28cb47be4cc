// SPDX-License-Identifier: MIT
// What is the smallest circle around a shape?
#pragma once
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct BoundingCircle {
    Vec2 center{0, 0};  ///< [m]
    double radius = 0;  ///< >= 0; 0 is a point [m]
};

/// The smallest circle around a placed shape: the smallest circle of its corners, which two or three of them define,
/// enlarged by the radius of its rounding. Rotation does not change its radius. The points are visited in a seeded
/// random order, so that the circle rarely has to grow: the time is proportional to their number.
/// Holds: every point is in it to about eight roundings of the largest coordinate. Throws std::invalid_argument unless
/// the shape is valid for a body, and finite at its pose. Source: Welzl, "Smallest enclosing disks (balls and
/// ellipsoids)", 1991. Test: "bounding circles hold 100,000 shapes, and are what all pairs and triples of corners make"
BoundingCircle boundingCircleOf(const Shape& shape, const Transform& pose = {});

/// The smallest circle around points. Throws std::invalid_argument if there are none, or one is not finite.
BoundingCircle boundingCircleOf(std::span<const Vec2> points);

/// Do they overlap or touch? |b - a|^2 <= (ra + rb)^2
bool overlap(const BoundingCircle& a, const BoundingCircle& b);
bool contains(const BoundingCircle& circle, const Vec2& point);

}  // namespace plumb
