// SPDX-License-Identifier: MIT
// How does one go to a place, away from it, or there to stay?
#pragma once
#include <optional>

#include <plumb/steering/agent.h>

namespace plumb {

/// At full speed towards the target, and past it. Nothing where it stands on the target.
/// Source of all three: Reynolds 1999, "Seek", "Flee", "Arrival".
/// Test: "an agent that seeks passes its target at full speed, and comes back"
Vec2 seek(const Agent& agent, const Vec2& target);

/// At full speed away from the threat; straight on where it stands on it.
Vec2 flee(const Agent& agent, const Vec2& threat);

/// Towards the target at the speed V d / D, no more than V, and stays there; d distance, D slowing distance [m].
/// Without one, D = 4 V max(t, V / (2 A)), t the response time: then it never has to brake with more than half of
/// A, and swings past the target by less than 1 % of D. Throws std::invalid_argument on a slowing distance that is
/// not positive. Test: "10,000 agents arrive, stay, and swing past by less than 1 % of the slowing distance"
Vec2 arrive(const Agent& agent, const Vec2& target, std::optional<double> slowingDistance = std::nullopt);

/// D of an agent, as arrive takes it [m].
double slowingDistanceOf(const Agent& agent);

}  // namespace plumb
