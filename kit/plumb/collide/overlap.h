// SPDX-License-Identifier: MIT
// Do two placed shapes overlap, which way, and how deep?
#pragma once
#include <optional>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct Overlap {
    double depth = 0;   ///< >= 0: shifted by this along normal, B just touches A [m]
    Vec2 normal{0, 1};  ///< unit, from A to B: the shortest way out [-]
    Vec2 pointA{0, 0};  ///< of A, deepest in B, in the world [m]
    Vec2 pointB{0, 0};  ///< of B, deepest in A: pointA - depth normal, in the world [m]
};

/// The lecture's overlap test; empty when the shapes are apart. Touching counts, with a depth of 0.
/// depth = -separation of distance() (see there), after the upright boxes around the two have been seen to overlap.
/// A chain is as deep as the deepest of its segments, which have no inside. What lies at a place that is not finite
/// overlaps nothing. Throws std::invalid_argument unless both shapes are ones that a body can have. It sees one moment:
/// what passes through between two of them it does not (see bisection.h and sweep.h). Test: "two shapes overlap, and as
/// deep, as the Minkowski difference says, 1,000,000 times"
std::optional<Overlap> overlap(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB);

}  // namespace plumb
