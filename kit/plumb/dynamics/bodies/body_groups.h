// SPDX-License-Identifier: MIT
// Which bodies are connected, directly or through others?
//
// Source: union-find with path halving: Tarjan, van Leeuwen, J. ACM 31 (1984) 245.
#pragma once
#include <algorithm>
#include <numeric>

#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// Sets of bodies; each set is named by the lowest slot in it.
class BodyGroups {
public:
    explicit BodyGroups(std::size_t bodies) : parent_(bodies) {
        std::iota(parent_.begin(), parent_.end(), BodyIndex{0});
    }
    BodyIndex of(BodyIndex body) {
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }
    void unite(BodyIndex a, BodyIndex b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

private:
    std::vector<BodyIndex> parent_;
};

}  // namespace plumb
