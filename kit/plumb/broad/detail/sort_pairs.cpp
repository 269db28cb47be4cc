// SPDX-License-Identifier: MIT
#include <plumb/broad/detail/sort_pairs.h>

#include <algorithm>

namespace plumb {

SortedPairs sortPairs(std::span<const Pair> found, std::size_t count) {
    std::vector<std::size_t> starts(count + 1);
    for (const Pair& pair : found) ++starts[pair.a + std::size_t{1}];
    for (std::size_t i = 0; i < count; ++i) starts[i + 1] += starts[i];
    SortedPairs pairs(found.size());
    for (const Pair& pair : found) pairs[starts[pair.a]++] = pair;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < count; ++i) {  // by now starts[i] is where i's pairs end
        std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin),
                  pairs.begin() + static_cast<std::ptrdiff_t>(starts[i]));
        begin = starts[i];
    }
    return pairs;
}

}  // namespace plumb
