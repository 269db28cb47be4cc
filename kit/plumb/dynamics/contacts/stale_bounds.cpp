// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/stale_bounds.h>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

namespace {

void addStale(const Space& space, const BodyStore& bodies, BodyIndex body, std::vector<StaleBound>& bounds) {
    const Transform pose = bodies.pose(body);
    for (const ProxyId proxy : bodies.links[body].proxies) {
        const Aabb box = aabbOf(space[proxy].def.shape, pose);
        if (!contains(space.box(proxy), box)) bounds.push_back({proxy, box});
    }
}

}  // namespace

std::span<const StaleBound> StaleBounds::of(const Space& space, const BodyStore& bodies) const {
    if (known_) return bounds_;
    const std::lock_guard lock(mutex_);
    if (known_) return bounds_;
    bounds_.clear();
    for (const BodyIndex body : bodies.awake)
        if (!isSurelyWithinItsBounds(bodies, body)) addStale(space, bodies, body, bounds_);
    known_ = true;
    return bounds_;
}

}  // namespace plumb
