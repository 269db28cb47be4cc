// SPDX-License-Identifier: MIT
// How much memory does a vector hold?
#pragma once
#include <cstddef>
#include <vector>

namespace plumb {

/// Beside itself, and beside what its items hold [bytes].
template <class Item>
std::size_t bytesOf(const std::vector<Item>& items) {
    return items.capacity() * sizeof(Item);
}

}  // namespace plumb
