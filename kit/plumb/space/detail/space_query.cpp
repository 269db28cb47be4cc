// SPDX-License-Identifier: MIT
// What lies in a box, along a way or near a point of the space? Of one that wraps around, see space_query_around.cpp.
#include <plumb/space/space.h>

#include <algorithm>

namespace plumb {

void Space::query(const Aabb& box, Visit visit) const {
    if (wrap_.any()) {
        queryAround(crowds_, box, visit);
        return;
    }
    const Vec2 none(0, 0);
    const Bounds bounds = BoundsRounding(origin_)(box);
    for (const Crowd& crowd : crowds_) {
        crowd.tree.query(bounds, [&](std::uint32_t slot) {
            const ProxyId id = crowd.tree.members()[slot];
            if (!seats_[id].moved && overlap(placed_[id].box, box)) visit(id, none);
        });
    }
    // The hierarchies have these where they were at the last look.
    for (const ProxyId id : moved_)
        if (seats_[id].moved && overlap(placed_[id].box, box)) visit(id, none);
}

void Space::queryFixed(const Aabb& box, Visit visit) const {
    const Crowd& crowd = crowds_[static_cast<std::size_t>(Home::Fixed)];
    if (wrap_.any()) {
        queryAround({&crowd, 1}, box, [&](ProxyId id, const Vec2& shift) {
            if (seats_[id].fixed) visit(id, shift);
        });
        return;
    }
    const Vec2 none(0, 0);
    crowd.tree.query(BoundsRounding(origin_)(box), [&](std::uint32_t slot) {
        const ProxyId id = crowd.tree.members()[slot];
        if (!seats_[id].moved && overlap(placed_[id].box, box)) visit(id, none);
    });
    for (const ProxyId id : moved_)
        if (seats_[id].moved && seats_[id].fixed && overlap(placed_[id].box, box)) visit(id, none);
}

void Space::probe(const BoxProbe& probe, float limit, FunctionRef<float(ProxyId)> visit) const {
    for (const Crowd& crowd : crowds_) {
        limit = crowd.tree.probe(probe, limit, [&](std::uint32_t slot) {
            const ProxyId id = crowd.tree.members()[slot];
            if (!seats_[id].moved) limit = visit(id);
            return limit;
        });
    }
}

/// Of a part of the way; visit gives the fraction of the whole way.
void Space::castTrees(const Vec2& halfSize, const Vec2& from, const Vec2& to, const RayPart& part,
                      FunctionRef<double(ProxyId)> visit) const {
    const Vec2 way = to - from, first = from + way * part.first, last = from + way * part.last;
    const auto limitOf = [&](double fraction) {
        return probeLimit((fraction - part.first) / std::max(part.last - part.first, 1e-300));
    };
    probe(rayProbe(first, last, halfSize, origin_, lanes_), limitOf(1), [&](ProxyId id) { return limitOf(visit(id)); });
}

void Space::castBox(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const {
    if (wrap_.any()) {
        castAround(halfSize, from, to, visit);
        return;
    }
    const Vec2 none(0, 0);
    const RayPart part = partWithin(halfSize, from, to);
    double wanted = 1;
    if (part.first <= part.last)
        castTrees(halfSize, from, to, part, [&](ProxyId id) { return wanted = visit(id, none); });
    for (const ProxyId id : moved_) {
        if (!seats_[id].moved) continue;
        const Aabb& box = placed_[id].box;
        const RayPart met = clipRay(from, to, {box.lower - halfSize, box.upper + halfSize});
        if (met.first <= met.last && met.first <= wanted) wanted = visit(id, none);
    }
}

void Space::findNear(const Vec2& point, double within, VisitWhile visit) const {
    if (wrap_.any()) {
        findAround(point, within, visit);
        return;
    }
    const Vec2 none(0, 0);
    probe(pointProbe(point, origin_, lanes_), probeLimit(within), [&](ProxyId id) {
        within = visit(id, none);
        return probeLimit(within);
    });
    constexpr double nearly = 1 - 1e-12;  // roundings must not leave out what is just so far
    for (const ProxyId id : moved_) {
        if (!seats_[id].moved) continue;
        const Aabb& box = placed_[id].box;
        const Vec2 away = (box.lower - point).cwiseMax(point - box.upper);
        if (away.maxCoeff() * nearly <= within) within = visit(id, none);
    }
}

}  // namespace plumb
