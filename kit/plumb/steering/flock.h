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

/// Away from each neighbour by A (1 - r / R), r its distance [m], all together no more than A. One at the very same
/// place does not count, so the agent itself may be among the others.
/// Source of all three: Reynolds, "Flocks, herds, and schools: a distributed behavioral model", SIGGRAPH 1987, and
/// 1999. Throws std::invalid_argument on a neighbourhood that is not as above.
/// Test: "twenty that separate come no nearer than ..."
Vec2 separate(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

/// To the neighbours' mean velocity. Test: "the headings of a flock that aligns come together"
Vec2 align(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

/// To the middle of the neighbours, as arrive goes there. Test: "a flock that coheres shrinks"
Vec2 cohere(const Agent& agent, std::span<const Seen> others, const Neighborhood& neighborhood = {});

}  // namespace plumb
