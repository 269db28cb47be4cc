// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/stale_bounds.h>

#include <cmath>

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

/// Waits until no other thread holds the flag, then holds it.
class HeldFlag {
public:
    explicit HeldFlag(std::atomic_flag& flag) : flag_(flag) {
        while (flag_.test_and_set(std::memory_order_acquire)) {
        }
    }
    ~HeldFlag() { flag_.clear(std::memory_order_release); }
    HeldFlag(const HeldFlag&) = delete;
    HeldFlag& operator=(const HeldFlag&) = delete;

private:
    std::atomic_flag& flag_;
};

/// A cheap test that reads three cache lines: is the body so near to its predicted place that its shapes are surely
/// within their bounds? False means that this is not known. The bounds contain all places between the step's start and
/// the prediction, and half a contactMargin more on every side.
bool isSurelyWithin(const BodyStore& bodies, BodyIndex body) {
    if (bodies.step[body].boundsPending) return false;
    const BodyMotion& now = bodies.motion[body];
    const BodyPlace& then = bodies.place[body];
    const Vec2 moved(now.center.x() - static_cast<double>(then.highX) - static_cast<double>(then.lowX),
                     now.center.y() - static_cast<double>(then.highY) - static_cast<double>(then.lowY));
    // The rotation is measured by its chord: the displacement of a point 1 m from the centre.
    const double cos = now.rotation.cos - static_cast<double>(then.cos);
    const double sin = now.rotation.sin - static_cast<double>(then.sin);
    const double turned = std::sqrt(cos * cos + sin * sin) * bodies.record[body].turningRadius;
    const double spare = 0.5 * static_cast<double>(contactMargin);
    return excessOfPrediction(bodies, body, moved, turned) < 0.99 * spare;
}

}  // namespace

std::span<const StaleBound> StaleBounds::of(const Space& space, const BodyStore& bodies) const {
    if (known_) return bounds_;
    const HeldFlag held(busy_);
    if (known_) return bounds_;
    bounds_.clear();
    for (const BodyIndex body : bodies.awake)
        if (!isSurelyWithin(bodies, body)) addStale(space, bodies, body, bounds_);
    known_ = true;
    return bounds_;
}

}  // namespace plumb
