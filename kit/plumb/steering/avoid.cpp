// SPDX-License-Identifier: MIT
#include <plumb/steering/avoid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>

namespace plumb {
namespace {

/// How far from a centre a turn has to start to pass it at this distance.
double turningDistance(const Agent& agent, double distance) {
    const double turn = agent.maxSpeed * agent.maxSpeed / (agent.maxAcceleration / 2);
    return std::sqrt(distance * distance + 2 * distance * turn) + 2 * agent.maxSpeed * agent.responseTime;
}

/// The direction from the origin of the tangent to a circle around d with radius b, on the side of heading.
Vec2 tangentTo(const Vec2& d, double b, const Vec2& heading) {
    const double squared = d.squaredNorm();
    const double along = std::sqrt(std::max(0.0, squared - b * b));
    const double side = cross(d, heading) >= 0 ? 1 : -1;
    return (along * d + side * b * perp(d)) / squared;
}

Vec2 nearestOn(const WallSegment& wall, const Vec2& p) {
    const Vec2 along = wall.end - wall.start;
    const double squared = along.squaredNorm();
    if (squared == 0) return wall.start;
    return wall.start + std::clamp((p - wall.start).dot(along) / squared, 0.0, 1.0) * along;
}

/// The normal of a wall for an agent at offset off from it. For an agent exactly on it: the side that it does not move
/// towards, back to where it came from; at rest, the left of the wall's direction; for a wall of zero length, opposite
/// to the heading.
Vec2 normalOf(const WallSegment& wall, const Agent& agent, const Vec2& off) {
    if (!off.isZero(0)) return detail::directionOf(off);
    const Vec2 left = perp(detail::directionOf(wall.end - wall.start));
    if (left.isZero(0)) return -headingOf(agent);
    return agent.velocity.dot(left) > 0 ? Vec2(-left) : left;
}

/// A velocity without its components against the normals. Removing one may bring back another, but a smaller one: in a
/// corner of 60 degrees, half of it.
Vec2 withoutTowards(Vec2 velocity, const std::vector<Vec2>& normals) {
    for (int pass = 0; pass < 10; ++pass)
        for (const Vec2& normal : normals) velocity += std::max(0.0, -velocity.dot(normal)) * normal;
    return velocity;
}

}  // namespace

Vec2 avoidObstacles(const Agent& agent, std::span<const RoundObstacle> obstacles, double clearance) {
    validate(agent);
    requireNotNegative(clearance, "avoidObstacles: clearance");
    const Vec2 heading = headingOf(agent);
    const bool moves = !agent.velocity.isZero(0);
    double first = std::numeric_limits<double>::infinity();
    Vec2 wanted(0, 0);
    for (const RoundObstacle& obstacle : obstacles) {
        requireFinite(obstacle.center, "RoundObstacle", ".center");
        requireNotNegative(obstacle.radius, "RoundObstacle", ".radius");
        const Vec2 d = obstacle.center - agent.position;
        const double distance = d.norm(), b = agent.radius + obstacle.radius + clearance;
        if (distance >= turningDistance(agent, b)) continue;
        const double along = d.dot(heading), across = std::fabs(cross(heading, d));
        if (distance > b && (!moves || along <= 0 || across >= b)) continue;
        const double reached = distance > b ? along - std::sqrt(b * b - across * across) : distance - b;
        if (reached >= first) continue;
        first = reached;
        wanted = distance > b ? tangentTo(d, b, heading) : d.isZero(0) ? heading : Vec2(-detail::directionOf(d));
    }
    return wanted.isZero(0) ? Vec2(0, 0) : steerTo(agent, agent.maxSpeed * wanted);
}

Vec2 avoidWalls(const Agent& agent, std::span<const WallSegment> walls, double clearance) {
    validate(agent);
    requireNotNegative(clearance, "avoidWalls: clearance");
    std::vector<Vec2> normals;  // of the walls in the way
    Vec2 away(0, 0);
    for (const WallSegment& wall : walls) {
        requireFinite(wall.start, "WallSegment", ".start");
        requireFinite(wall.end, "WallSegment", ".end");
        const Vec2 off = agent.position - nearestOn(wall, agent.position);
        const Vec2 normal = normalOf(wall, agent, off);
        const double room = off.norm() - agent.radius - clearance;
        const double towards = -agent.velocity.dot(normal);
        const double needed = towards * towards / agent.maxAcceleration + 2 * towards * agent.responseTime;
        if (room > 0 && (towards <= 0 || room >= needed)) continue;
        normals.push_back(normal);
        if (room <= 0) away += normal;
    }
    if (normals.empty()) return {0, 0};
    const Vec2 wanted = withoutTowards(agent.velocity, normals) + agent.maxSpeed * away;
    return steerTo(agent, detail::limited(wanted, agent.maxSpeed));
}

}  // namespace plumb
