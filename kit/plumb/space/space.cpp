// SPDX-License-Identifier: MIT
#include <plumb/space/space.h>

#include <algorithm>
#include <limits>

namespace plumb {

namespace {

Aabb emptyBox() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{inf, inf}, {-inf, -inf}};
}

}  // namespace

bool mayPair(const Proxy& a, const Proxy& b) {
    const Filter& fa = a.def.filter;
    const Filter& fb = b.def.filter;
    return a.owner != b.owner && !(a.fixed && b.fixed) && (fa.category & fb.mask) != 0 && (fb.category & fa.mask) != 0;
}

ProxyId Space::add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight) {
    ProxyId id = 0;
    if (free_.empty()) {
        id = static_cast<ProxyId>(proxies_.size());
        proxies_.emplace_back();
    } else {
        id = free_.back();
        free_.pop_back();
    }
    proxies_[id] = {def, convexOf(def.shape, localCenter), owner, fixed, true, true, tight, emptyBox()};
    movedProxies_.push_back(id);
    fixedChanged_ = fixedChanged_ || fixed;
    return id;
}

void Space::remove(ProxyId proxy) {
    proxies_[proxy].alive = false;
    fixedChanged_ = fixedChanged_ || proxies_[proxy].fixed;
    if (proxies_[proxy].moved) std::erase(movedProxies_, proxy);
    free_.push_back(proxy);
}

void Space::place(ProxyId id, const Aabb& tight, double margin) {
    Proxy& proxy = proxies_[id];
    if (contains(proxy.box, tight)) return;
    proxy.box = inflate(tight, margin);
    if (proxy.fixed) fixedChanged_ = true;
    if (proxy.moved) return;
    proxy.moved = true;
    movedProxies_.push_back(id);
}

void Space::renew(ProxyId id) {
    Proxy& proxy = proxies_[id];
    proxy.previousBox = emptyBox();
    if (proxy.moved) return;
    proxy.moved = true;
    movedProxies_.push_back(id);
}

void Space::rebuildTrees() {
    fixedMembers_.clear();
    movingMembers_.clear();
    std::vector<Aabb> fixedBoxes, movingBoxes;
    for (ProxyId id = 0; id < proxies_.size(); ++id) {
        const Proxy& proxy = proxies_[id];
        if (!proxy.alive) continue;
        (proxy.fixed ? fixedMembers_ : movingMembers_).push_back(id);
        (proxy.fixed ? fixedBoxes : movingBoxes).push_back(proxy.box);
    }
    movingTree_.build(movingBoxes);
    if (fixedChanged_) fixedTree_.build(fixedBoxes);
    fixedChanged_ = false;
}

void Space::collectPairs(ProxyId id, const Bvh& tree, const std::vector<ProxyId>& members, SortedPairs& pairs) const {
    const Proxy& proxy = proxies_[id];
    tree.query(proxy.box, [&](std::uint32_t index) {
        const ProxyId otherId = members[index];
        const Proxy& other = proxies_[otherId];
        if (other.moved && otherId <= id) return;  // the other finds this one
        if (!mayPair(proxy, other) || overlap(proxy.previousBox, other.previousBox)) return;
        pairs.push_back({std::min(id, otherId), std::max(id, otherId)});
    });
}

SortedPairs Space::takeNewPairs() {
    SortedPairs pairs;
    if (movedProxies_.empty()) return pairs;
    rebuildTrees();
    for (const ProxyId id : movedProxies_) {
        collectPairs(id, movingTree_, movingMembers_, pairs);
        if (!proxies_[id].fixed) collectPairs(id, fixedTree_, fixedMembers_, pairs);
    }
    for (const ProxyId id : movedProxies_) {
        proxies_[id].previousBox = proxies_[id].box;
        proxies_[id].moved = false;
    }
    movedProxies_.clear();
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace plumb
