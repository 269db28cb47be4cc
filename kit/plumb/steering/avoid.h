// SPDX-License-Identifier: MIT
// How does an agent avoid obstacles and walls?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// A circular obstacle, such as a pillar or a tree.
struct RoundObstacle {
    Vec2 center{0, 0};  ///< [m]
    double radius = 1;  ///< >= 0 [m]
};

/// A wall, effective on both sides.
struct WallSegment {
    Vec2 start{0, 0}, end{1, 0};  ///< [m]
};

/// Steers around the first obstacle that the agent would hit, along the tangent to it on the nearer side; zero when
/// nothing is in the way. It starts to turn as late as a turn with half of A allows:
///   at a distance of sqrt(B^2 + 2 B V^2 / (A / 2)) + 2 V t from the obstacle's centre
/// B the sum of both radii and the clearance [m], t response time. Inside of B it steers straight away from the
/// obstacle, and from its very centre along the heading. An agent at rest hits nothing: only obstacles that it is
/// inside of count. Throws std::invalid_argument on a radius or a clearance that is negative or not finite, and on
/// positions that are not finite. Source: Reynolds 1999, "Obstacle avoidance"; distance: the circle of the turn touches
/// the obstacle.
/// Test: "who avoids first and seeks then comes through 10,000 woods without touching a tree"
Vec2 avoidObstacles(const Agent& agent, std::span<const RoundObstacle> obstacles, double clearance = 0.2);

/// Steers along a wall, or away from several: removes the velocity component towards any wall that could not be avoided
/// by braking with half of A; zero when nothing is in the way.
///   in the way: d - B < u^2 / A + 2 u t
/// d distance of the wall [m], B radius and clearance [m], u speed towards it [m/s], t response time. Holds where no
/// corner is sharper than 60 degrees. From exactly on a wall, to the side that it came from; at rest, to the left of
/// the direction from start to end. Source: Reynolds 1999, "Containment" and "Wall following"; the distance is the
/// braking distance. Test: "who keeps off walls stays in 10,000 rooms, with a screen in the middle"
Vec2 avoidWalls(const Agent& agent, std::span<const WallSegment> walls, double clearance = 0.2);

}  // namespace plumb
