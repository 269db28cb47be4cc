// SPDX-License-Identifier: MIT
// Which of n things are connected, directly or through others?
//
// Source: union-find with path halving: Tarjan, van Leeuwen, J. ACM 31 (1984) 245.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include <plumb/math/detail/step_list.h>

namespace plumb {

/// Sets of the numbers from 0 on; each set is named by its lowest number.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    std::uint32_t of(std::uint32_t each) {
        while (parent_[each] != each) each = parent_[each] = parent_[parent_[each]];
        return each;
    }
    void unite(std::uint32_t a, std::uint32_t b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

private:
    StepList<std::uint32_t> parent_;
};

}  // namespace plumb
