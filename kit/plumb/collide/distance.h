// SPDX-License-Identifier: MIT
// How far apart are two placed shapes?
#pragma once
#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// How far apart two shapes are, and where.
struct Distance {
    double separation = 0;  ///< negative when they overlap: minus the depth along normal [m]
    Vec2 normal{0, 1};      ///< unit, from A to B
    Vec2 pointA{0, 0};      ///< nearest (or deepest) point of A, in the world [m]
    Vec2 pointB{0, 0};      ///< nearest (or deepest) point of B: pointA + separation normal, in the world [m]
};

/// The signed distance of two shapes, in double precision.
/// separated:   min over corners p of one and edges e of the other of |p - e|
/// overlapping: max over edges (v, n) of one of min over corners p of the other of n . (p - v), a negative number
/// minus the radii; the only corner of a circle is its centre. A segment, as the core of a capsule, is two edges back
/// to back with an end cap of zero length at either end. The distance of a chain is that of its nearest segment.
/// Source: separating axes, as the edges of the Minkowski difference are those of both shapes.
/// Holds: to about five roundings of the sizes and of the distance of the two; the position in the world adds none. Of
/// directions of equal length it returns the first edge's, A's before B's; for concentric circles (0, 1).
/// The shapes must be valid for a body: for speed only the number of corners is checked, and std::invalid_argument
/// thrown on too few or too many. validate() refuses all other faults, such as a clockwise polygon. Where a pose is not
/// finite, neither is the separation.
/// Test: "distances of 10,000 placements of each pair of shapes agree with the Minkowski difference"
Distance distance(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB);

}  // namespace plumb
