// SPDX-License-Identifier: MIT
// Where does a ray hit a shape?
#pragma once
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Where a ray, or a shape that is translated, first hits another shape.
struct CastPoint {
    Vec2 point{0, 0};     ///< in the world [m]
    Vec2 normal{0, 1};    ///< unit, outward from the shape; against the motion where it started inside [-]
    double fraction = 0;  ///< of the ray, 0 to 1; 0 where it started inside or touching [-]
};

/// The first point of a shape on the ray from one point to another; empty when there is none. Exact to rounding:
/// circle:  |m + t d| = r, by the distance of its centre from the ray's line, so that no large squares cancel
/// polygon: t = n . (v - p) / n . d for each edge (v, n): the last edge entered, if it is before the first edge left;
///          with a radius the edges are offset by it, and beyond their ends the circle of a corner is tested
/// capsule: the same for its two sides
/// segment: its ends lie on different sides of the ray's line. A ray never slips through a vertex of a chain or
///          through the ends of two segments that share a point; a ray along a segment hits its end.
/// p, d the ray's start and displacement [m], t the fraction [-], m its start from the circle's centre [m]
/// A ray of zero length hits the shape that it lies in; its normal is then the direction of the shortest way out. A ray
/// that is not finite hits nothing.
/// The shapes must be valid for a body: for speed only the number of corners is checked, and std::invalid_argument
/// thrown on too few or too many. validate() refuses all other faults, such as a clockwise polygon.
/// Source: polygon: Cyrus and Beck, "Generalized two- and three-dimensional clipping", 1978.
/// Test: "where 20,000 rays meet each shape is where the distance to it comes to nothing"
std::optional<CastPoint> castRay(const Vec2& from, const Vec2& to, const Shape& shape, const Transform& pose);

}  // namespace plumb
