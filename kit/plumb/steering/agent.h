// SPDX-License-Identifier: MIT
// What is an agent that steers, and how does it move?
#pragma once
#include <string_view>

#include <plumb/math/vec2.h>

namespace plumb {

/// A vehicle in Reynolds' sense: a point that may accelerate in any direction, within limits. Every behaviour of this
/// module takes one and returns the acceleration it requests [m/s^2], at most maxAcceleration, and zero if there is
/// nothing to do. Each throws std::invalid_argument unless maxSpeed, maxAcceleration and responseTime are positive, the
/// radius is not negative, and these and all positions, velocities and accelerations are finite.
struct Agent {
    Vec2 position{0, 0};         ///< [m]
    Vec2 velocity{0, 0};         ///< [m/s]
    double radius = 0.5;         ///< >= 0 [m]
    double maxSpeed = 3;         ///< V, > 0 [m/s]
    double maxAcceleration = 6;  ///< A, > 0 [m/s^2]
    double responseTime = 0.1;   ///< t: time to reach the wanted velocity, > 0 [s]
};

/// Throws std::invalid_argument unless the agent is as above; field is its name in the message.
void validate(const Agent& agent, std::string_view field = "Agent");

/// The direction of its velocity; +x at rest [-].
Vec2 headingOf(const Agent& agent);

/// a = (u - v) / t, at most A; u wanted velocity, v velocity [m/s].
/// Source: Reynolds, "Steering behaviors for autonomous characters", Game Developers Conference, 1999, "steering =
/// desired - velocity", with a time so that it is the same at any frame rate.
/// Test: "no behaviour asks for more than the agent has, or for what is no number, 100,000 times"
Vec2 steerTo(const Agent& agent, const Vec2& wantedVelocity);

/// The agent after a time dt >= 0 [s]: v' = v + a dt, at most V, x' = x + (v + v') dt / 2. For agents that are not
/// bodies of a world; for a body, mass times acceleration is a force.
Agent moved(const Agent& agent, const Vec2& acceleration, double dt);

}  // namespace plumb
