// SPDX-License-Identifier: MIT
// How does one follow a way?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// A line through points, walked from the first to the last, and to the first again if it is closed.
struct Path {
    std::span<const Vec2> points = {};  ///< two or more [m]
    bool closed = false;
};

struct PathStep {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    double progress = 0;      ///< for the next time: how far along the path it has come, over all rounds [m]
};

/// Seeks the point of the path that lies a way ahead, L, of where the agent is abreast of it; it arrives at the
/// end of an open path, slowing down in time. progress is what the last step returned, 0 at the start: the path is
/// looked at from there to L beyond, so that it may cross itself. On bends of radius B or more it cuts the
/// corners, by less than L^2 / (2 B), where it can turn so sharply and looks neither too near nor past the bend:
///   V^2 <= A B / 2,  2 V t <= L <= B / 2
/// V, A, t the agent's speed, acceleration and response time. Source: Reynolds 1999, "Path following"; the point
/// ahead: Coulter, "Implementation of the pure pursuit path tracking algorithm", CMU-RI-TR-92-01, 1992. Throws
/// std::invalid_argument on less than two points, points that are not finite, a path of no length, a progress that
/// is negative or not finite, and an ahead that is not positive.
/// Tests: "who follows 1,000 winding paths keeps within their radius, and comes to their end",
///        "a path that crosses itself is walked to its end, and a ring round and round"
PathStep followPath(const Agent& agent, const Path& path, double progress, double ahead);

double lengthOf(const Path& path);  ///< of one round, if it is closed [m]

/// The point as far along the path [m]; of a closed one, after whole rounds too.
Vec2 pointOn(const Path& path, double along);

}  // namespace plumb
