// SPDX-License-Identifier: MIT
// What does one do who wants several things at once?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// What a behaviour would like, and how much that counts.
struct Wish {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    double weight = 1;        ///< >= 0 [-]
};

// Each keeps to the agent's maxAcceleration, and returns zero for no wishes. Source: Reynolds 1999, "Combining
// behaviors". Throw std::invalid_argument as all do, and on a weight that is negative or not finite,
// or what it makes of a wish.
// Test: "blends keep to the budget, 100,000 times"

/// All together: the sum of weight times acceleration. What pulls against each other may cancel.
Vec2 steerByWeight(const Agent& agent, std::span<const Wish> wishes);

/// One after the other, most important first, each in full as long as there is any left of maxAcceleration: the
/// last that gets something gets the rest. Weights scale the wishes.
Vec2 steerByBudget(const Agent& agent, std::span<const Wish> wishes);

/// Only the first that wants anything at all.
Vec2 steerByPriority(const Agent& agent, std::span<const Wish> wishes);

}  // namespace plumb
