// SPDX-License-Identifier: MIT
#include <plumb/math/detail/sorting.h>

#include <numeric>

namespace plumb {

/// Merges runs of 1, 2, 4, ... items.
StepList<std::uint32_t> sortedOrder(std::size_t count, FunctionRef<bool(std::uint32_t, std::uint32_t)> isBefore) {
    StepList<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    if (std::is_sorted(order.begin(), order.end(), isBefore)) return order;
    StepList<std::uint32_t> merged(count);
    for (std::size_t width = 1; width < count; width *= 2) {
        for (std::size_t first = 0; first < count; first += 2 * width) {
            const std::uint32_t* from = order.data() + first;
            const std::uint32_t* middle = order.data() + std::min(first + width, count);
            const std::uint32_t* end = order.data() + std::min(first + 2 * width, count);
            std::merge(from, middle, middle, end, merged.data() + first, isBefore);
        }
        order.swap(merged);
    }
    return order;
}

}  // namespace plumb
