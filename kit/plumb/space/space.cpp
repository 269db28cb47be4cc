// SPDX-License-Identifier: MIT
#include <plumb/space/space.h>

#include <algorithm>
#include <limits>

#include <plumb/math/detail/bytes_of.h>

namespace plumb {

namespace {

/// Of what was nowhere: overlaps nothing, not even the whole plane.
Aabb nowhere() {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    return {{notANumber, notANumber}, {notANumber, notANumber}};
}

}  // namespace

ProxyId Space::acquire() {
    if (!free_.empty()) {
        const ProxyId id = free_.back();
        free_.pop_back();
        return id;
    }
    proxies_.emplace_back();
    placed_.emplace_back();
    previousBoxes_.emplace_back();
    seats_.emplace_back();
    gates_.emplace_back();
    return static_cast<ProxyId>(proxies_.size() - 1);
}

ProxyId Space::add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight,
                   std::uint32_t number, bool piece, PieceUse use) {
    const ProxyId id = acquire();
    proxies_[id] = {def, convexOf(def.shape, localCenter), owner, number, piece, use, fixed, true};
    proxies_[id].convex.oneSided = use == PieceUse::Touch;
    gates_[id] = gateOf(proxies_[id]);
    seats_[id].fixed = fixed;
    placed_[id].box = tight;
    if (wrap_.any()) {
        if (rounds_.size() <= id) rounds_.resize(id + std::size_t{1});
        rounds_[id] = {id, {0, 0}, {0, 0}, {}};
    }
    renew(id);
    return id;
}

void Space::remove(ProxyId id) {
    hide(id);
    proxies_[id].alive = false;
    free_.push_back(id);
}

void Space::hide(ProxyId id) {
    leave(id);
    seats_[id].moved = false;
    if (wrap_.any()) dropImages(id);
}

void Space::change(ProxyId id, const ShapeDef& def) {
    proxies_[id].def = def;
    gates_[id] = gateOf(proxies_[id]);
}

void Space::change(ProxyId id, bool fixed, const Vec2& localCenter) {
    proxies_[id].convex = convexOf(proxies_[id].def.shape, localCenter);
    proxies_[id].convex.oneSided = proxies_[id].use == PieceUse::Touch;
    proxies_[id].fixed = fixed;
    gates_[id] = gateOf(proxies_[id]);
    seats_[id].fixed = fixed;
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
    if (wrap_.any())
        crowd.tree.forgetPrevious(seats_[id].slot);
    else
        crowd.tree.putPrevious(seats_[id].slot, BoundsRounding(origin_)(previousBox(id)));
}

void Space::reserve(std::size_t shapes) {
    proxies_.reserve(shapes);
    placed_.reserve(shapes);
    previousBoxes_.reserve(shapes);
    seats_.reserve(shapes);
    gates_.reserve(shapes);
    free_.reserve(shapes);
    moved_.reserve(shapes);
    crowdOf(Home::Moving).tree.reserve(shapes);
}

std::size_t Space::bytes() const {
    std::size_t bytes = bytesOf(proxies_) + bytesOf(placed_) + bytesOf(previousBoxes_) + bytesOf(seats_) +
                        bytesOf(gates_) + bytesOf(free_) + bytesOf(moved_) + bytesOf(pairs_) + bytesOf(sortBoxes_) +
                        bytesOf(unsorted_) + bytesOf(sorted_) + bytesOf(rounds_) + bytesOf(shiftedPairs_) +
                        bytesOf(pairShifts_) + mortonSort_.bytes() + pairSort_.bytes();
    for (const Crowd& crowd : crowds_) bytes += crowd.tree.bytes();
    for (const Rounds& rounds : rounds_) bytes += bytesOf(rounds.images);
    for (const Proxy& proxy : proxies_) {
        bytes += proxy.convex.vertices.bytes() + proxy.convex.normals.bytes();
        if (const auto* polygon = std::get_if<Polygon>(&proxy.def.shape)) bytes += bytesOf(polygon->vertices);
    }
    return bytes;
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
