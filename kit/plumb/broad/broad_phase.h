// SPDX-License-Identifier: MIT
// Which boxes overlap, and how many tests does it take to find out? Four methods, one result.
#pragma once
#include <array>
#include <span>

#include <plumb/broad/brute_force.h>
#include <plumb/broad/bvh.h>
#include <plumb/broad/grid.h>
#include <plumb/broad/pair.h>
#include <plumb/broad/sweep_and_prune.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

enum class BroadPhase { BruteForce, Grid, SweepAndPrune, Bvh };
inline constexpr std::array broadPhases{BroadPhase::BruteForce, BroadPhase::Grid, BroadPhase::SweepAndPrune,
                                        BroadPhase::Bvh};

/// The pairs of boxes that overlap or touch: the same, in the same order, for every method. A box with a NaN coordinate
/// overlaps nothing; infinite coordinates are allowed. Each method's header defines what it counts as a test:
/// brute_force.h, grid.h, sweep_and_prune.h, bvh.h.
/// Tests for n evenly distributed boxes, at constant density, grow as
///   brute force n^2, grid n, sweep and prune n^1.5, hierarchy n
/// Test: "all broad phases find equal pairs in 1,000 scenes", "tests grow as ..."
inline PairSearch findPairs(BroadPhase method, std::span<const Aabb> boxes) {
    switch (method) {
        case BroadPhase::BruteForce: return bruteForcePairs(boxes);
        case BroadPhase::Grid: return gridPairs(boxes);
        case BroadPhase::SweepAndPrune: return sweepAndPrunePairs(boxes);
        case BroadPhase::Bvh: break;
    }
    Bvh bvh;
    bvh.build(boxes);
    return bvh.countedPairs();
}

}  // namespace plumb
