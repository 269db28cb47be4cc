// SPDX-License-Identifier: MIT
// Which boxes overlap, and what does it cost to find out? Four ways, one answer.
#pragma once
#include <array>
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

enum class BroadPhase { BruteForce, Grid, SweepAndPrune, Bvh };
inline constexpr std::array broadPhases{BroadPhase::BruteForce, BroadPhase::Grid, BroadPhase::SweepAndPrune,
                                        BroadPhase::Bvh};

/// The pairs of boxes that overlap or touch: the same, in the same order, in every way. A box with a coordinate that is
/// not a number overlaps nothing; infinite ones are boxes like others. What each way counts as a test is said where it
/// is: brute_force.h, grid.h, sweep_and_prune.h, bvh.h.
/// Tests made for n boxes that lie evenly, at constant density, grow as
///   brute force n^2, grid n, sweep and prune n^1.5, hierarchy n
/// Test: "all broad phases find equal pairs in 1,000 scenes", "tests grow as ..."
PairSearch findPairs(BroadPhase way, std::span<const Aabb> boxes);

}  // namespace plumb
