// SPDX-License-Identifier: MIT
// How does one catch what moves, or keep from being caught by it?
#pragma once
#include <plumb/steering/agent.h>

namespace plumb {

/// Another one, as it is seen.
struct Seen {
    Vec2 position{0, 0};  ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// Throws std::invalid_argument unless both are finite.
void validate(const Seen& seen, std::string_view field = "Seen");

/// Seeks where the quarry will be met if it goes on as it does: after the least T >= 0 with |d + w T| = V T, and
/// where there is none, or it is longer, after mostAhead [s].
///   T = d^2 / (sqrt((d . w)^2 + (V^2 - w^2) d^2) - d . w)
/// d from the agent to the quarry [m], w velocity of the quarry, V speed of the agent [m/s]. Source: Reynolds
/// 1999, "Pursuit", with the time of meeting for his estimate. Throws std::invalid_argument on a mostAhead that is
/// negative or not finite. Test: "who pursues catches no later than who seeks in 20,000 chases, and a tenth sooner
/// in the mean". That holds for one that starts at rest and stops within a second, and a quarry 3 m off or more: who
/// takes longer to turn, or stands closer, may shoot past the place of meeting and be the later one.
Vec2 pursue(const Agent& agent, const Seen& quarry, double mostAhead = 5);

/// Flees from where the pursuer will be after T = D / (V + |w|), and no more than mostAhead [s]: were they to run
/// straight at each other they would meet then, so one that heads this way is still in front of the agent. A pursuer
/// that is faster, comes closer and could be here within mostAhead would catch who runs before it: out of its line of
/// travel straight to the side, the one the agent is on, and to the pursuer's left from right before it. D distance of
/// the pursuer [m], w its velocity, V speed of the agent [m/s]. Throws as above. Source: Reynolds 1999, "Evasion", with
/// this time and the step aside added. Tests: "who evades 20,000 stampedes is missed by a metre, who flees is not", "a
/// slower pursuer that seeks loses ground in 2,000 chases but for the start"
Vec2 evade(const Agent& agent, const Seen& pursuer, double mostAhead = 5);

}  // namespace plumb
