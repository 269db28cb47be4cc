// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/strays.h>

#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

namespace {

void addStrays(const WorldState& world, BodyIndex body, std::vector<Stray>& strays) {
    const Transform pose = world.bodies.pose(body);
    for (const ProxyId proxy : world.bodies.record[body].proxies) {
        const Aabb box = aabbOf(world.space[proxy].def.shape, pose);
        if (!contains(world.space.box(proxy), box)) strays.push_back({proxy, box});
    }
}

}  // namespace

std::span<const Stray> Strays::of(const WorldState& world) const {
    if (known_) return strays_;
    const std::lock_guard lock(mutex_);
    if (known_) return strays_;
    strays_.clear();
    for (const BodyIndex body : world.bodies.awake) addStrays(world, body, strays_);
    known_ = true;
    return strays_;
}

bool hasLeftItsBoxes(const WorldState& world, BodyIndex body) {
    std::vector<Stray> strays;
    addStrays(world, body, strays);
    return !strays.empty();
}

}  // namespace plumb
