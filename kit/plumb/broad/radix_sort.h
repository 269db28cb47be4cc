// SPDX-License-Identifier: MIT
// How are many items sorted by an unsigned key, without comparing them?
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumb {

/// Byte by byte, the lowest first; a byte that all keys share is skipped. Items with equal keys keep their order.
/// keyOf(item) is an unsigned number of keyBytes bytes. Keeps its memory from call to call.
/// Source: Knuth, TAOCP 3, 5.2.5.
template <class Item, unsigned keyBytes>
class RadixSort {
public:
    template <class KeyOf>
    void operator()(std::span<Item> items, KeyOf&& keyOf) {
        if (items.size() < 2) return;
        std::array<std::array<std::uint32_t, 256>, keyBytes> counts{};
        for (const Item& item : items)
            for (unsigned byte = 0; byte < keyBytes; ++byte) ++counts[byte][keyOf(item) >> 8 * byte & 255];
        if (other_.size() < items.size()) other_.resize(items.size());
        std::span<Item> from = items;
        std::span<Item> to = std::span(other_).first(items.size());
        for (unsigned byte = 0; byte < keyBytes; ++byte) {
            if (counts[byte][keyOf(items[0]) >> 8 * byte & 255] == items.size()) continue;
            std::uint32_t sum = 0;
            for (std::uint32_t& count : counts[byte]) sum += std::exchange(count, sum);
            for (const Item& item : from) to[counts[byte][keyOf(item) >> 8 * byte & 255]++] = item;
            std::swap(from, to);
        }
        if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
    }

    /// Memory in use.
    std::size_t bytes() const { return other_.capacity() * sizeof(Item); }

private:
    std::vector<Item> other_;
};

}  // namespace plumb
