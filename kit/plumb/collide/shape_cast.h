// SPDX-License-Identifier: MIT
// Where does a shape that is shifted meet another?
#pragma once
#include <optional>

#include <plumb/collide/ray_cast.h>

namespace plumb {

/// How one shape, shifted straight on without turning, first meets another that stays; empty when it does not. The
/// point and the normal are of the one that stays. Of two that overlap at the start, its point that is deepest in the
/// other; shifted by nothing, the normal is the shortest way out. At a place that is not finite nothing is met.
///   t' = t + s(t) / -(n . d)
/// t fraction of the way [-], s the distance there [m], n the normal of it [-], d the shift [m]
/// The distance of convex shapes along a straight way is a convex function of t, so Newton's method comes to its first
/// zero from below, never beyond it, and where the distance does not shrink it never will.
/// Shapes are ones that a body can have: for the engine's sake only counts are looked at, and std::invalid_argument
/// thrown on too few corners or too many. Others, as a polygon that runs clockwise, validate() refuses.
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3, without turning.
/// Test: "where 20,000 shifted shapes of each two kinds meet is where the Minkowski difference says"
std::optional<CastPoint> castShape(const Shape& moving, const Transform& pose, const Vec2& shift, const Shape& target,
                                   const Transform& targetPose);

}  // namespace plumb
