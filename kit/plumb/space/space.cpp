// SPDX-License-Identifier: MIT
#include <plumb/space/space.h>

#include <algorithm>
#include <limits>

namespace plumb {

namespace {

/// Of what was nowhere: overlaps nothing, not even the whole plane.
Aabb nowhere() {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    return {{notANumber, notANumber}, {notANumber, notANumber}};
}

}  // namespace

ProxyId Space::add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight,
                   std::uint32_t number) {
    ProxyId id = static_cast<ProxyId>(proxies_.size());
    if (free_.empty()) {
        proxies_.emplace_back();
        placed_.emplace_back();
        previousBoxes_.emplace_back();
        seats_.emplace_back();
        gates_.emplace_back();
    } else {
        id = free_.back();
        free_.pop_back();
    }
    proxies_[id] = {def, convexOf(def.shape, localCenter), owner, number, fixed, true};
    gates_[id] = gateOf(proxies_[id]);
    seats_[id].fixed = fixed;
    placed_[id].box = tight;
    renew(id);
    return id;
}

void Space::remove(ProxyId id) {
    leave(id);
    proxies_[id].alive = false;
    seats_[id].moved = false;
    free_.push_back(id);
}

void Space::markMoved(ProxyId id) {
    Seat& seat = seats_[id];
    if (seat.moved) return;
    previousBoxes_[id] = placed_[id];
    seat.moved = true;
    if (!seat.listed) moved_.push_back(id);
    seat.listed = true;
}

void Space::renewBox(ProxyId id, const Aabb& tight, double margin) {
    markMoved(id);
    placed_[id].box = inflate(tight, margin);
}

void Space::renew(ProxyId id) {
    markMoved(id);
    previousBoxes_[id].box = nowhere();
    seats_[id].fresh = true;
}

void Space::leave(ProxyId id) {
    Seat& seat = seats_[id];
    if (seat.home == Home::None) return;
    Crowd& crowd = crowdOf(seat.home);
    crowd.tree.erase(seat.slot);
    ++crowd.changes;
    seat.home = Home::None;
}

void Space::enter(ProxyId id, Home home) {
    Crowd& crowd = crowdOf(home);
    seats_[id].slot = crowd.tree.append(id);
    seats_[id].home = home;
    ++crowd.changes;
    crowd.tree.putPrevious(seats_[id].slot, BoundsRounding(origin_)(previousBox(id)));
}

/// A ray that goes far beyond all there is would be coarse in floats.
RayPart Space::partWithin(const Vec2& halfSize, const Vec2& from, const Vec2& to) const {
    constexpr double far = 8192;
    const Vec2 reach = (from - origin_).cwiseAbs().cwiseMax((to - origin_).cwiseAbs());
    if (reach.maxCoeff() < far) return {};
    RayPart part{1, 0};
    for (const Crowd& crowd : crowds_) {
        const Bounds bounds = crowd.tree.bounds();
        if (!(bounds.lowerX <= bounds.upperX)) continue;
        const Vec2 lower(static_cast<double>(bounds.lowerX), static_cast<double>(bounds.lowerY));
        const Vec2 upper(static_cast<double>(bounds.upperX), static_cast<double>(bounds.upperY));
        // A millionth more, for the roundings of the bounds.
        const Vec2 spare = halfSize + 1e-6 * (lower.cwiseAbs().cwiseMax(upper.cwiseAbs()));
        const RayPart here = clipRay(from, to, {lower + origin_ - spare, upper + origin_ + spare});
        if (!(here.first <= here.last)) continue;
        part =
            part.first <= part.last ? RayPart{std::min(part.first, here.first), std::max(part.last, here.last)} : here;
    }
    return part;
}

}  // namespace plumb
