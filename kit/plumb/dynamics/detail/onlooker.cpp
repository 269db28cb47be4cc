// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/onlooker.h>

#include <limits>

namespace plumb {

void Onlooker::lookAlong(const Vec2& halfSize, const Vec2& from, const Vec2& to, Space::VisitWhile visit) const {
    double wanted = 1;
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (sees(id)) wanted = visit(id, shift);
        return wanted;
    };
    world_.space.castBox(halfSize, from, to, look);
    const Aabb way{from.cwiseMin(to) - halfSize, from.cwiseMax(to) + halfSize};
    forEachStray(way, [&](const Stray& stray, const Vec2& shift) {
        const Vec2 lower = stray.box.lower + shift - halfSize, upper = stray.box.upper + shift + halfSize;
        const RayPart met = clipRay(from, to, {lower, upper});
        if (met.first <= met.last) look(stray.proxy, shift);
    });
}
void Onlooker::lookAround(const Vec2& point, double within, Space::VisitWhile visit) const {
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (sees(id)) within = visit(id, shift);
        return within;
    };
    world_.space.findNear(point, within, look);
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Wrap& wrap = world_.def.wrap;
    const Vec2 reach(wrap.width.value_or(endless), wrap.height.value_or(endless));
    forEachStray({point - reach, point + reach},
                 [&](const Stray& stray, const Vec2& shift) { look(stray.proxy, shift); });
}
void Onlooker::lookInto(const Aabb& tight, Space::Visit visit) const {
    // What just touches is not to be lost to roundings.
    const Aabb box = inflate(tight, 1e-15 * tight.lower.cwiseAbs().cwiseMax(tight.upper.cwiseAbs()).maxCoeff());
    const auto look = [&](ProxyId id, const Vec2& shift) {
        if (sees(id)) visit(id, shift);
    };
    world_.space.query(box, look);
    forEachStray(box, [&](const Stray& stray, const Vec2& shift) {
        if (overlap({stray.box.lower + shift, stray.box.upper + shift}, box)) look(stray.proxy, shift);
    });
}
void Onlooker::forEachStray(const Aabb& where, FunctionRef<void(const Stray&, const Vec2&)> visit) const {
    for (const Stray& stray : world_.strays.of(world_)) {
        const Proxy& proxy = world_.space[stray.proxy];
        if (!proxy.alive || !world_.bodies.record[proxy.owner].enabled) continue;
        if (world_.def.wrap.any())
            world_.space.forEachShift(where, stray.box, [&](const Vec2& shift) { visit(stray, shift); });
        else
            visit(stray, Vec2(0, 0));
    }
}

}  // namespace plumb
