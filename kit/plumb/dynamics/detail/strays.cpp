// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/strays.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/fresh_lanes.h>
#include <plumb/dynamics/detail/pairs.h>
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

/// Is it so near to where the step foresaw it that its boxes hold it? Costs a look at three cache lines; a no is no
/// proof. Boxes hold all between the step's start and what was foreseen, and half a contactMargin more all around.
bool surelyKept(const WorldState& world, BodyIndex body) {
    if (world.bodies.record[body].boxesWait) return false;
    const BodyMotion& now = world.bodies.motion[body];
    const BodyPlace& then = world.bodies.place[body];
    const Vec2 shift = foreseenShift(world, body);
    const auto aside = [](double at, float high, float low, double foreseen) {
        const double moved = at - static_cast<double>(high) - static_cast<double>(low);
        return std::max(std::min(foreseen, 0.0) - moved, moved - std::max(foreseen, 0.0));
    };
    const double x = aside(now.center.x(), then.highX, then.lowX, shift.x());
    const double y = aside(now.center.y(), then.highY, then.lowY, shift.y());
    // By the chord, which is how far a point turns that is 1 m from the centre.
    const double cos = now.rotation.cos - static_cast<double>(then.cos);
    const double sin = now.rotation.sin - static_cast<double>(then.sin);
    const double turned = std::sqrt(cos * cos + sin * sin) * world.bodies.record[body].reach;
    const double spare = 0.5 * static_cast<double>(contactMargin);
    return std::max({x, y, 0.0}) + std::max(turned - static_cast<double>(then.turn), 0.0) < 0.99 * spare;
}

}  // namespace

std::span<const Stray> Strays::of(const WorldState& world) const {
    if (known_) return strays_;
    const std::lock_guard lock(mutex_);
    if (known_) return strays_;
    strays_.clear();
    for (const BodyIndex body : world.bodies.awake)
        if (!surelyKept(world, body)) addStrays(world, body, strays_);
    known_ = true;
    return strays_;
}

bool hasLeftItsBoxes(const WorldState& world, BodyIndex body) {
    std::vector<Stray> strays;
    addStrays(world, body, strays);
    return !strays.empty();
}

}  // namespace plumb
