// SPDX-License-Identifier: MIT
// How much memory does a vector hold?
#pragma once
#include <cstddef>
#include <vector>

namespace plumb {

/// Heap memory, without what the items themselves allocate [bytes].
template <class Item>
std::size_t bytesOf(const std::vector<Item>& items) {
    return items.capacity() * sizeof(Item);
}

}  // namespace plumb
