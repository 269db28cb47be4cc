// SPDX-License-Identifier: MIT
// How do many stay together without running into each other?
#pragma once
#include <numbers>
#include <span>

#include <plumb/steering/agent.h>
#include <plumb/steering/pursue.h>

namespace plumb {

/// Which of the others count.
struct Neighborhood {
    double radius = 5;               ///< R: those farther off do not, > 0 [m]
    double view = std::numbers::pi;  ///< nor those farther than this from its heading, to either side, 0 to pi [rad]
};

/// Away from each neighbour by A (1 - r / R), r its distance [m], all together no more than A. One at the very
/// same place does not count, so the agent itself may be among the others.
/// Source of all three: Reynolds, "Flocks, herds, and schools: a distributed behavioral model", SIGGRAPH 1987, and
/// 1999. Throws std::invalid_argument on a neighbourhood that is not as above.
/// Test: "thirty that separate and come to rest are no nearer than their radius to each other"
Vec2 separate(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

/// To the neighbours' mean velocity. Test: "the headings of 30 flocks of thirty that align come together"
Vec2 align(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

/// To the middle of the neighbours, as arrive goes there, but with them: beside their mean velocity.
/// Test: "30 flocks of thirty that cohere shrink to a tenth, and no agent flies off"
Vec2 cohere(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

}  // namespace plumb
