// SPDX-License-Identifier: MIT
// How does an agent move to a point, away from it, or stop at it?
#pragma once
#include <optional>

#include <plumb/steering/agent.h>

namespace plumb {

/// At full speed towards the target, and past it. Zero if it is exactly at the target.
/// Source of all three: Reynolds 1999, "Seek", "Flee", "Arrival".
/// Test: "an agent that seeks passes its target at full speed, and comes back"
Vec2 seek(const Agent& agent, const Vec2& target);

/// At full speed away from the threat; straight on if it is exactly at the threat.
Vec2 flee(const Agent& agent, const Vec2& threat);

/// Towards the target at the speed V d / D, at most V, and stops there; d distance, D slowing distance [m]. If none is
/// given, D = 4 V max(t, V / (2 A)), t the response time: then it never has to brake with more than half of A, and
/// overshoots the target by less than 1 % of D. Throws std::invalid_argument on a slowing distance that is not
/// positive. Test: "10,000 agents arrive, stay, and swing past by less than 1 % of the slowing distance"
Vec2 arrive(const Agent& agent, const Vec2& target, std::optional<double> slowingDistance = std::nullopt);

/// The default D of an agent [m].
double slowingDistanceOf(const Agent& agent);

}  // namespace plumb
