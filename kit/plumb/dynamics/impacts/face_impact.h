// SPDX-License-Identifier: MIT
// Which impulses part two bodies that meet at a point, or at both ends of a common face?
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

/// What B was given at a point, along the normal and along perp(normal) [N s].
struct PointImpulse {
    Vec2 point{0, 0};
    double normal = 0, tangent = 0;
};

/// Where two shapes on bodies that move like that touch: one point, or both ends of a common face. size: of the larger
/// of the two, as a bounding radius [m].
std::vector<Vec2> touchingPoints(const Convex& a, const BodyMotion& motionA, const Convex& b, const BodyMotion& motionB,
                                 const Distance& where, double size);

/// Changes the velocities of the two by the impulses of an impact at one point or two. normal: from A to B.
std::vector<PointImpulse> solveImpact(std::span<const Vec2> points, const Vec2& normal, const ImpactLaw& law,
                                      ImpactBody& a, ImpactBody& b);

}  // namespace plumb
