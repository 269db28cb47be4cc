// SPDX-License-Identifier: MIT
// Which is the smallest circle that holds a shape?
#pragma once
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct BoundingCircle {
    Vec2 center{0, 0};  ///< [m]
    double radius = 0;  ///< >= 0; 0 is a point [m]
};

/// The smallest circle around a placed shape: that around its corners, which two or three of them determine, and the
/// radius of its rounding. Turning a shape does not change it. The points are looked at in a seeded random order, so
/// that a circle that has to grow does so seldom: time grows as their number.
/// Holds: every point lies in it to about eight roundings of the largest coordinate. Throws std::invalid_argument
/// unless the shape is one that a body can have, and finite where it lies. Source: Welzl, "Smallest enclosing disks
/// (balls and ellipsoids)", 1991. Test: "bounding circles hold 100,000 shapes, and are what all pairs and triples of
/// corners make"
BoundingCircle boundingCircleOf(const Shape& shape, const Transform& pose = {});

/// Around points. Throws std::invalid_argument if there are none, or one is not finite.
BoundingCircle boundingCircleOf(std::span<const Vec2> points);

/// Do they overlap or touch? |b - a|^2 <= (ra + rb)^2
bool overlap(const BoundingCircle& a, const BoundingCircle& b);
bool contains(const BoundingCircle& circle, const Vec2& point);

}  // namespace plumb
