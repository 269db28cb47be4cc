// SPDX-License-Identifier: MIT
// How does one keep clear of what stands in the way?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// A pillar, a tree.
struct RoundObstacle {
    Vec2 center{0, 0};  ///< [m]
    double radius = 1;  ///< >= 0 [m]
};

/// A wall, seen from both sides.
struct WallSegment {
    Vec2 start{0, 0}, end{1, 0};  ///< [m]
};

/// Out of the way of the first obstacle that it would run into, along the tangent from it to the nearer side; zero
/// when nothing is in the way. It turns away as late as a turn with half of A allows:
///   at a distance of sqrt(B^2 + 2 B V^2 / (A / 2)) + 2 V t from the obstacle's centre
/// B the sum of both radii and the clearance [m], t response time. Once inside of B, straight away from it, and from
/// its very centre along the heading. One that stands still runs into nothing: only what it is inside of counts. Throws
/// std::invalid_argument on a radius or a clearance that is negative or not finite, and on places that are not
/// finite. Source: Reynolds 1999, "Obstacle avoidance"; distance: the circle of the turn touches the obstacle.
/// Test: "who avoids first and seeks then comes through 10,000 woods without touching a tree"
Vec2 avoidObstacles(const Agent& agent, std::span<const RoundObstacle> obstacles, double clearance = 0.2);

/// Along the wall, or away from several: whatever of the velocity goes towards a wall from which it could not keep
/// clear otherwise, braking with half of A, is taken out of it; zero when nothing is in the way.
///   in the way: d - B < u^2 / A + 2 u t
/// d distance of the wall [m], B radius and clearance [m], u speed towards it [m/s], t response time. Holds where no
/// corner is sharper than 60 degrees. From right on a wall, to the side that it came from; at rest, to the left of the
/// way from start to end. Source: Reynolds 1999, "Containment" and "Wall following"; the distance is the one it takes
/// to brake. Test: "who keeps off walls stays in 10,000 rooms, with a screen in the middle"
Vec2 avoidWalls(const Agent& agent, std::span<const WallSegment> walls, double clearance = 0.2);

}  // namespace plumb
