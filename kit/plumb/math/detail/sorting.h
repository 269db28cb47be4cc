// SPDX-License-Identifier: MIT
// How are lists sorted that are short, or sorted seldom? By code that all of them share: std::sort brings 4 to 7 KB for
// each type of item into a page's module. Items of equal keys keep their order, whatever the standard library.
// It takes 1.4 to 2.7 times as long (3 to 10,000 items): so the broad phase, which sorts long lists, has std::sort.
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include <plumb/math/detail/step_list.h>
#include <plumb/math/function_ref.h>

namespace plumb {

/// For each place of the sorted list: the index of the item that belongs there. isBefore compares two items, by their
/// indices.
StepList<std::uint32_t> sortedOrder(std::size_t count, FunctionRef<bool(std::uint32_t, std::uint32_t)> isBefore);

/// Sorts by keyOf(item), the smallest first. Returns whether that has moved any.
template <class List, class KeyOf>
bool sortBy(List& items, KeyOf&& keyOf) {
    if (items.size() < 2) return false;
    StepList<std::uint32_t> order =
        sortedOrder(items.size(), [&](std::uint32_t a, std::uint32_t b) { return keyOf(items[a]) < keyOf(items[b]); });
    bool isMoved = false;
    for (std::uint32_t start = 0; start < order.size(); ++start) {
        if (order[start] == start) continue;
        isMoved = true;
        auto held = std::move(items[start]);
        std::uint32_t place = start;
        for (std::uint32_t from = order[start]; from != start; from = order[place]) {
            items[place] = std::move(items[from]);
            order[place] = place;
            place = from;
        }
        items[place] = std::move(held);
        order[place] = place;
    }
    return isMoved;
}

/// The same, and keeps the first of the items of one key.
template <class List, class KeyOf>
void sortOnceBy(List& items, KeyOf&& keyOf) {
    sortBy(items, keyOf);
    const auto isSame = [&](const auto& a, const auto& b) { return keyOf(a) == keyOf(b); };
    items.erase(std::unique(items.begin(), items.end(), isSame), items.end());
}

}  // namespace plumb
