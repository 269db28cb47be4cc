// SPDX-License-Identifier: MIT
// How does an agent follow a path?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// A polyline, followed from the first point to the last, and back to the first if it is closed.
struct Path {
    std::span<const Vec2> points = {};  ///< two or more [m]
    bool closed = false;
};

struct PathStep {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    double progress = 0;      ///< for the next call: distance covered along the path, over all rounds [m]
};

/// Seeks the point of the path at a distance ahead, L, beyond the point nearest to the agent; it arrives at the end of
/// an open path, slowing down in time. progress is the result of the last step, 0 at the start: the path is searched
/// from there to L beyond, so that it may cross itself. On bends of radius B or more it cuts the corners by less than
/// L^2 / (2 B), if it can turn so sharply and L is neither too short nor reaches past the bend:
///   V^2 <= A B / 2,  2 V t <= L <= B / 2
/// V, A, t the agent's speed, acceleration and response time. Source: Reynolds 1999, "Path following"; the point ahead:
/// Coulter, "Implementation of the pure pursuit path tracking algorithm", CMU-RI-TR-92-01, 1992. Throws
/// std::invalid_argument on less than two points, points that are not finite, a path of length 0, a progress that is
/// negative or not finite, and an ahead that is not positive.
/// Tests: "who follows 1,000 winding paths keeps within their radius, and comes to their end",
///        "a path that crosses itself is walked to its end, and a ring round and round"
PathStep followPath(const Agent& agent, const Path& path, double progress, double ahead);

double lengthOf(const Path& path);  ///< of one round, if it is closed [m]

/// The point at this distance along the path [m]; on a closed path also beyond one round.
Vec2 pointOn(const Path& path, double along);

}  // namespace plumb
