// SPDX-License-Identifier: MIT
// Where does a ray meet a shape?
#pragma once
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Where what moves straight on meets a shape first.
struct CastPoint {
    Vec2 point{0, 0};     ///< in the world [m]
    Vec2 normal{0, 1};    ///< unit, outward from the shape; against the motion where it began inside [-]
    double fraction = 0;  ///< of the way, 0 to 1; 0 where it began inside or touching [-]
};

/// The first point of a shape on the way from one point to another; empty when there is none. Exact to rounding:
/// circle:  |m + t d| = r, by the distance of its centre from the ray's line, so that no large squares cancel
/// polygon: t = n . (v - p) / n . d for each edge (v, n): the last that is entered, if it comes before any that is
/// left;
///          with a radius the edges lie that far out, and beyond their ends it is a corner's circle that is met
/// capsule: the same for its two sides
/// segment: its ends lie on different sides of the ray's line. A line through a chain's joint never slips through, nor
///          does one through the ends of two segments that share a point; a ray along a segment meets its end.
/// p, d the ray's start and way [m], t the fraction [-], m its start from the circle's centre [m]
/// A ray of no length meets what it lies in; its normal is then the nearest way out. What is not finite meets
/// nothing.
/// Shapes are ones that a body can have: for the engine's sake only counts are looked at, and std::invalid_argument
/// thrown on too few corners or too many. Others, as a polygon that runs clockwise, validate() refuses.
/// Source: polygon: Cyrus and Beck, "Generalized two- and three-dimensional clipping", 1978.
/// Test: "where 20,000 rays meet each shape is where the distance to it comes to nothing"
std::optional<CastPoint> castRay(const Vec2& from, const Vec2& to, const Shape& shape, const Transform& pose);

}  // namespace plumb
