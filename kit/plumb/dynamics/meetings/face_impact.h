// SPDX-License-Identifier: MIT
// Which impulses act between two bodies that hit each other at a point, or at both ends of a common face?
#pragma once
#include <span>
#include <vector>

#include <plumb/collide/convex.h>
#include <plumb/collide/distance.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/impact/impact.h>

namespace plumb {

/// A body in an impact.
struct ImpactBody {
    BodyMotion motion;
    double inverseMass = 0, inverseInertia = 0;
};

/// The impulse on B at a point, along the normal and along perp(normal) [N s].
struct PointImpulse {
    Vec2 point{0, 0};
    double normal = 0, tangent = 0;
};

/// Where two shapes touch whose bodies are in these states: one point, or both ends of a common face. size: bounding
/// radius of the larger body [m].
std::vector<Vec2> touchingPoints(const Convex& a, const BodyMotion& motionA, const Convex& b, const BodyMotion& motionB,
                                 const Distance& where, double size);

/// Applies an impact at one or two points to the velocities of both bodies; returns the impulses. normal: from A to B.
std::vector<PointImpulse> solveImpact(std::span<const Vec2> points, const Vec2& normal, const ImpactLaw& law,
                                      ImpactBody& a, ImpactBody& b);

}  // namespace plumb
