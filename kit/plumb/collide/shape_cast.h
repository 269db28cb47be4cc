// SPDX-License-Identifier: MIT
// Where does a translated shape hit another?
#pragma once
#include <optional>

#include <plumb/collide/ray_cast.h>

namespace plumb {

/// How one shape, translated without rotation, first hits another that is at rest; empty when it does not. The point
/// and the normal are those of the shape at rest. If the two overlap at the start, the point is the one of the resting
/// shape that is deepest in the other; for a translation of zero, the normal is the direction of the shortest way out.
/// At a position that is not finite nothing is hit.
///   t' = t + s(t) / -(n . d)
/// t fraction of the translation [-], s the distance there [m], n its normal [-], d the translation [m]
/// The distance of convex shapes along a straight line is a convex function of t, so Newton's method reaches its first
/// zero from below, never beyond it; where the distance does not shrink, it never will.
/// The shapes must be valid for a body: for speed only the number of corners is checked, and std::invalid_argument
/// thrown on too few or too many. validate() refuses all other faults, such as a clockwise polygon.
/// Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3, without rotation.
/// Test: "where 20,000 shifted shapes of each two kinds meet is where the Minkowski difference says"
std::optional<CastPoint> castShape(const Shape& moving, const Transform& pose, const Vec2& shift, const Shape& target,
                                   const Transform& targetPose);

}  // namespace plumb
