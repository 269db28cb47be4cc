// SPDX-License-Identifier: MIT
#include <plumb/broad/sweep_and_prune.h>

#include <algorithm>

#include <plumb/broad/detail/sorted_pairs.h>

namespace plumb {
namespace {

/// The interval of a box on the axis.
struct Interval {
    double begin, end;
    std::uint32_t index;
};

/// Of the centres of all boxes with a finite centre, halved so that no sum overflows; NaN where a square overflows.
Vec2 varianceOf(std::span<const Aabb> boxes) {
    Vec2 mean(0, 0), sum(0, 0);
    double count = 0;
    for (const Aabb& box : boxes) {
        const Vec2 center = 0.25 * box.lower + 0.25 * box.upper;
        if (!center.allFinite()) continue;
        count += 1;
        const Vec2 off = center - mean;
        mean += off / count;
        sum += off.cwiseProduct(center - mean);
    }
    return sum / std::max(count, 1.0);
}

}  // namespace

PairSearch sweepAndPrunePairs(std::span<const Aabb> boxes) {
    const Vec2 variance = varianceOf(boxes);
    const int axis = variance.y() > variance.x() ? 1 : 0;
    std::vector<Interval> intervals;
    intervals.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (hasNaN(boxes[i])) continue;
        const Aabb extent = ordered(boxes[i]);
        intervals.push_back({extent.lower[axis], extent.upper[axis], i});
    }
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.index < b.index;
    });

    PairSearch search;
    std::vector<Pair> found;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        for (std::size_t j = i + 1; j < intervals.size() && intervals[j].begin <= intervals[i].end; ++j) {
            ++search.tests;
            const std::uint32_t a = intervals[i].index, b = intervals[j].index;
            if (overlap(boxes[a], boxes[b])) found.push_back(pairOf(a, b));
        }
    }
    search.pairs = sortPairs(found, boxes.size());
    return search;
}

}  // namespace plumb
