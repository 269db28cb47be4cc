// SPDX-License-Identifier: MIT
// How does an agent intercept a moving target, or evade one?
#pragma once
#include <plumb/steering/agent.h>

namespace plumb {

/// Position and velocity of another agent.
struct AgentState {
    Vec2 position{0, 0};  ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// Throws std::invalid_argument unless both are finite.
void validate(const AgentState& seen, std::string_view field = "AgentState");

/// Seeks the point at which the quarry will be met if its velocity stays constant: after the least T >= 0 with |d + w
/// T| = V T, and if there is none, or it is longer, after mostAhead [s].
///   T = d^2 / (sqrt((d . w)^2 + (V^2 - w^2) d^2) - d . w)
/// d from the agent to the quarry [m], w velocity of the quarry, V speed of the agent [m/s]. Source: Reynolds 1999,
/// "Pursuit", with the exact interception time instead of his estimate. Throws std::invalid_argument on a mostAhead
/// that is negative or not finite. Test: "who pursues catches no later than who seeks in 20,000 chases, and a tenth
/// sooner in the mean". That holds for an agent that starts at rest and stops within a second, and a quarry at least 3
/// m away: an agent that takes longer to turn, or is closer, may overshoot the interception point and be later.
Vec2 pursue(const Agent& agent, const AgentState& quarry, double mostAhead = 5);

/// Flees from the pursuer's predicted position after T = D / (V + |w|), at most mostAhead [s]: the time in which they
/// would meet head-on, so that a pursuer that approaches is still in front of the agent. A pursuer that is faster,
/// approaches and could arrive within mostAhead would catch an agent that runs straight away: so the agent moves
/// sideways out of its line of travel, to the side that it is on, and to the pursuer's left from exactly in front. D
/// distance of the pursuer [m], w its velocity, V speed of the agent [m/s]. Throws as above. Source: Reynolds 1999,
/// "Evasion", with this time and the sidestep added. Tests: "who evades 20,000 stampedes is missed by a metre, who
/// flees is not", "a slower pursuer that seeks loses ground in 2,000 chases but for the start"
Vec2 evade(const Agent& agent, const AgentState& pursuer, double mostAhead = 5);

}  // namespace plumb
