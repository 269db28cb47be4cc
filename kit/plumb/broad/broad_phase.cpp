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

PairSearch bruteForcePairs(std::span<const Aabb> boxes) {
    PairSearch search;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (overlap(boxes[a], boxes[b])) search.pairs.push_back({a, b});
        search.tests += count - a - 1;
    }
    return search;
}

}  // namespace plumb
