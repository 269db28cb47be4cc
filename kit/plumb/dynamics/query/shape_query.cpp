// SPDX-License-Identifier: MIT
#include <plumb/dynamics/query/shape_query.h>

#include <limits>

namespace plumb {

/// First the space, nearest first, then the shapes that have left their bounds there, of which there are few.
void ShapeQuery::visitAlong(const Vec2& halfSize, const Vec2& from, const Vec2& to, Space::VisitWhile visit) const {
    double wanted = 1;
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (matches(id)) wanted = visit(id, shift);
        return wanted;
    };
    world_.space.castBox(halfSize, from, to, look);
    const Aabb way{from.cwiseMin(to) - halfSize, from.cwiseMax(to) + halfSize};
    forEachStale(way, [&](const StaleBound& stale, const Vec2& shift) {
        const Vec2 lower = stale.box.lower + shift - halfSize, upper = stale.box.upper + shift + halfSize;
        const RayPart met = clipRay(from, to, {lower, upper});
        if (met.first <= met.last) look(stale.proxy, shift);
    });
}

void ShapeQuery::visitNear(const Vec2& point, double within, Space::VisitWhile visit) const {
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (matches(id)) within = visit(id, shift);
        return within;
    };
    world_.space.findNear(point, within, look);
    // In a world that wraps, the nearest image of a shape is within one period.
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Wrap& wrap = world_.bodies.wrap;
    const Vec2 reach(wrap.width.value_or(endless), wrap.height.value_or(endless));
    forEachStale({point - reach, point + reach},
                 [&](const StaleBound& stale, const Vec2& shift) { look(stale.proxy, shift); });
}

void ShapeQuery::visitIn(const Aabb& tight, Space::Visit visit) const {
    // Rounding must not lose a shape that only touches.
    const Aabb box = inflate(tight, 1e-15 * tight.lower.cwiseAbs().cwiseMax(tight.upper.cwiseAbs()).maxCoeff());
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (matches(id)) visit(id, shift);
    };
    world_.space.query(box, look);
    forEachStale(box, [&](const StaleBound& stale, const Vec2& shift) {
        if (overlap({stale.box.lower + shift, stale.box.upper + shift}, box)) look(stale.proxy, shift);
    });
}

void ShapeQuery::forEachStale(const Aabb& where, FunctionRef<void(const StaleBound&, const Vec2&)> visit) const {
    for (const StaleBound& stale : world_.staleBounds.of(world_.space, world_.bodies)) {
        const Proxy& proxy = world_.space[stale.proxy];
        if (!proxy.alive || !world_.bodies.record[proxy.owner].enabled) continue;
        if (world_.bodies.wrap.any())
            world_.space.forEachShift(where, stale.box, [&](const Vec2& shift) { visit(stale, shift); });
        else
            visit(stale, Vec2(0, 0));
    }
}

}  // namespace plumb
