// SPDX-License-Identifier: MIT
// Which shapes are in a box, along a ray or near a point? For a space that wraps around see space_query_wrapped.cpp.
#include <plumb/space/detail/space.h>

#include <algorithm>

namespace plumb {

void Space::query(const Aabb& box, Visit visit) const {
    if (wrap_.any()) {
        queryWrapped(partitions_, box, visit);
        return;
    }
    const Vec2 none(0, 0);
    const Bounds bounds = BoundsRounding(origin_)(box);
    for (const Partition& partition : partitions_) {
        partition.tree.query(bounds, [&](std::uint32_t slot) {
            const ProxyId id = partition.tree.members()[slot];
            if (!entries_[id].moved && overlap(boxes_[id].box, box)) visit(id, none);
        });
    }
    // The trees still have these where they were at the last update.
    for (const ProxyId id : moved_)
        if (entries_[id].moved && overlap(boxes_[id].box, box)) visit(id, none);
}

void Space::queryFixed(const Aabb& box, Visit visit) const {
    const Partition& partition = partitions_[static_cast<std::size_t>(PartitionId::Fixed)];
    if (wrap_.any()) {
        queryWrapped({&partition, 1}, box, [&](ProxyId id, const Vec2& shift) {
            if (entries_[id].fixed) visit(id, shift);
        });
        return;
    }
    const Vec2 none(0, 0);
    partition.tree.query(BoundsRounding(origin_)(box), [&](std::uint32_t slot) {
        const ProxyId id = partition.tree.members()[slot];
        if (!entries_[id].moved && overlap(boxes_[id].box, box)) visit(id, none);
    });
    for (const ProxyId id : moved_)
        if (entries_[id].moved && entries_[id].fixed && overlap(boxes_[id].box, box)) visit(id, none);
}

void Space::probe(const BoxProbe& probe, float limit, FunctionRef<float(ProxyId)> visit) const {
    for (const Partition& partition : partitions_) {
        limit = partition.tree.probe(probe, limit, [&](std::uint32_t slot) {
            const ProxyId id = partition.tree.members()[slot];
            if (!entries_[id].moved) limit = visit(id);
            return limit;
        });
    }
}

/// For a part of the ray; visit returns a fraction of the whole ray.
void Space::castTrees(const Vec2& halfSize, const Vec2& from, const Vec2& to, const RayPart& part,
                      FunctionRef<double(ProxyId)> visit) const {
    const Vec2 path = to - from, first = from + path * part.first, last = from + path * part.last;
    const auto limitOf = [&](double fraction) {
        return probeLimit((fraction - part.first) / std::max(part.last - part.first, 1e-300));
    };
    probe(rayProbe(first, last, halfSize, origin_, lanes_), limitOf(1), [&](ProxyId id) { return limitOf(visit(id)); });
}

void Space::castBox(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const {
    if (wrap_.any()) {
        castWrapped(halfSize, from, to, visit);
        return;
    }
    const Vec2 none(0, 0);
    const RayPart part = clipToBounds(halfSize, from, to);
    double wanted = 1;
    if (part.first <= part.last)
        castTrees(halfSize, from, to, part, [&](ProxyId id) { return wanted = visit(id, none); });
    for (const ProxyId id : moved_) {
        if (!entries_[id].moved) continue;
        const Aabb& box = boxes_[id].box;
        const RayPart met = clipRay(from, to, {box.lower - halfSize, box.upper + halfSize});
        if (met.first <= met.last && met.first <= wanted) wanted = visit(id, none);
    }
}

void Space::findNear(const Vec2& point, double within, VisitWhile visit) const {
    if (wrap_.any()) {
        findNearWrapped(point, within, visit);
        return;
    }
    const Vec2 none(0, 0);
    probe(pointProbe(point, origin_, lanes_), probeLimit(within), [&](ProxyId id) {
        within = visit(id, none);
        return probeLimit(within);
    });
    constexpr double nearly = 1 - 1e-12;  // rounding must not leave out a box that is exactly this far
    for (const ProxyId id : moved_) {
        if (!entries_[id].moved) continue;
        const Aabb& box = boxes_[id].box;
        const Vec2 away = (box.lower - point).cwiseMax(point - box.upper);
        if (away.maxCoeff() * nearly <= within) within = visit(id, none);
    }
}

}  // namespace plumb
