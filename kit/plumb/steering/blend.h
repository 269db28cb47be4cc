// SPDX-License-Identifier: MIT
// How are several steering behaviours combined?
#pragma once
#include <span>

#include <plumb/steering/agent.h>

namespace plumb {

/// The acceleration that a behaviour requests, and its weight.
struct WeightedSteering {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    double weight = 1;        ///< >= 0 [-]
};

// Each result is at most the agent's maxAcceleration, and zero for an empty list. Source: Reynolds 1999, "Combining
// behaviors". Throw std::invalid_argument as all do, and on a weight, or a product of weight and acceleration, that is
// negative or not finite.
// Test: "blends keep to the budget, 100,000 times"

/// The sum of weight times acceleration. Opposite requests may cancel.
Vec2 steerByWeight(const Agent& agent, std::span<const WeightedSteering> requests);

/// One after the other, most important first, each in full as long as maxAcceleration is not used up: the last one gets
/// the rest. Weights scale the accelerations.
Vec2 steerByBudget(const Agent& agent, std::span<const WeightedSteering> requests);

/// Only the first that is not zero.
Vec2 steerByPriority(const Agent& agent, std::span<const WeightedSteering> requests);

}  // namespace plumb
