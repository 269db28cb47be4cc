// SPDX-License-Identifier: MIT
// What do arrays and vectors need beyond the standard: a short name for three numbers, and the memory that they hold.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace plumb {

/// Of up to three rows of a joint.
using Vec3 = std::array<double, 3>;

/// Heap memory, without what the items themselves allocate [bytes].
template <class Item>
std::size_t bytesOf(const std::vector<Item>& items) {
    return items.capacity() * sizeof(Item);
}

}  // namespace plumb
