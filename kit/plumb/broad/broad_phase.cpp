// SPDX-License-Identifier: MIT
#include <plumb/broad/broad_phase.h>

#include <plumb/broad/brute_force.h>
#include <plumb/broad/bvh.h>
#include <plumb/broad/grid.h>
#include <plumb/broad/sweep_and_prune.h>

namespace plumb {

PairSearch findPairs(BroadPhase method, std::span<const Aabb> boxes) {
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
