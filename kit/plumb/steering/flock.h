// SPDX-License-Identifier: MIT
// How does a group stay together without collisions?
#pragma once
#include <numbers>
#include <span>

#include <plumb/steering/agent.h>
#include <plumb/steering/pursue.h>

namespace plumb {

/// Which other agents are neighbours.
struct Neighborhood {
    double radius = 5;               ///< R: only those nearer than this, > 0 [m]
    double view = std::numbers::pi;  ///< only those within this angle of the heading, to either side, 0 to pi [rad]
};

/// Away from each neighbour by A (1 - r / R), r its distance [m], the sum limited to A. An agent at the very same
/// position does not count, so the agent itself may be in the list. Source of all three: Reynolds, "Flocks, herds, and
/// schools: a distributed behavioral model", SIGGRAPH 1987, and 1999. Throws std::invalid_argument on a neighbourhood
/// that is not as above.
/// Test: "thirty that separate and come to rest are no nearer than their radius to each other"
Vec2 separate(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood = {});

/// Towards the neighbours' mean velocity. Test: "the headings of 30 flocks of thirty that align come together"
Vec2 align(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood = {});

/// Towards the centre of the neighbours, as in arrive, but relative to their mean velocity.
/// Test: "30 flocks of thirty that cohere shrink to a tenth, and no agent flies off"
Vec2 cohere(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood = {});

}  // namespace plumb
