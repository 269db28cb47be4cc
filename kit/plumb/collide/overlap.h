// SPDX-License-Identifier: MIT
// Do two placed shapes overlap, in which direction, and how deep?
#pragma once
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct Overlap {
    double depth = 0;   ///< >= 0: translated by this along normal, B just touches A [m]
    Vec2 normal{0, 1};  ///< unit, from A to B: the direction of the shortest translation that separates them [-]
    Vec2 pointA{0, 0};  ///< of A, deepest in B, in the world [m]
    Vec2 pointB{0, 0};  ///< of B, deepest in A: pointA - depth normal, in the world [m]
};

/// The lecture's overlap test; empty when the shapes are apart. Touching counts, with a depth of 0.
/// depth = -separation of distance() (see there), computed if the axis-aligned boxes of the two overlap. The depth of a
/// chain is that of its deepest segment; segments have no inside. A shape at a position that is not finite overlaps
/// nothing. Throws std::invalid_argument unless both shapes are valid for a body. It tests one moment: a shape that
/// passes through between two tests is not found (see bisection.h and sweep.h).
/// Test: "two shapes overlap, and as deep, as the Minkowski difference says, 1,000,000 times"
std::optional<Overlap> overlap(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB);

}  // namespace plumb
