// SPDX-License-Identifier: MIT
// Which shapes are there to be found, for whoever looks through a filter?
#pragma once
#include <limits>

#include <plumb/collide/ray_cast.h>
#include <plumb/dynamics/detail/world_state.h>
#include <plumb/dynamics/query.h>

namespace plumb {

/// Finds candidates by their boxes, wherever the last step or a call since has moved them: all that are in question,
/// some that are not, and some twice.
class Onlooker {
public:
    Onlooker(const WorldState& world, const Filter& filter, BodyIndex ignored = noBody)
        : world_(world), gate_{filter.category, filter.mask, 0, filter.group}, ignored_(ignored) {}

    /// From now on also finds outlines that stand for areas elsewhere.
    void seeOutlines() { outlines_ = true; }
    /// Is this a part of an outline, or of an area, that stands for the other?
    bool isOutline(ProxyId id) const { return world_.space[id].use == PieceUse::Touch; }
    bool isArea(ProxyId id) const { return world_.space[id].use == PieceUse::Ask; }

    const Shape& shape(ProxyId id) const { return world_.space[id].def.shape; }
    /// Where it was found, in a world that wraps.
    Transform pose(ProxyId id, const Vec2& shift) const {
        return shifted(world_.bodies.pose(world_.space[id].owner), shift);
    }
    Vec2 place(const Vec2& point) const { return world_.def.wrap.place(point); }
    ShapeId idOf(ProxyId id) const { return world_.idOfShape(id); }
    CastHit hitOf(ProxyId id, const Vec2& shift, const CastPoint& met) const {
        CastHit hit{idOf(id), place(met.point), met.normal, met.fraction};
        if (const std::optional<Vec2>& open = world_.space[id].def.oneWay)
            hit.oneWay = pose(id, shift).rotation * *open;
        hit.tile = tileMet(world_, id, met.point - shift, met.normal);
        return hit;
    }

    /// Whatever a box of this half size may meet on its way; visit(id, shift) gives the fraction of it up to which more
    /// is wanted.
    template <class Visit>
    void lookAlong(const Vec2& halfSize, const Vec2& from, const Vec2& to, Visit&& visit) const {
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

    /// Whatever may be no farther from a point than within; visit(id, shift) gives the distance up to which more is
    /// wanted.
    template <class Visit>
    void lookAround(const Vec2& point, double within, Visit&& visit) const {
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

    /// Whatever may be in a box.
    template <class Visit>
    void lookInto(const Aabb& tight, Visit&& visit) const {
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

private:
    bool sees(ProxyId id) const {
        const Gate& gate = world_.space.gate(id);
        return mayMeet(gate_, gate) && (gate.asked || (outlines_ && gate.touched)) && !gate.sensor &&
               gate.owner != ignored_;
    }

    /// With each shift by which it may be in a box; without one in a world that does not wrap.
    template <class Visit>
    void forEachStray(const Aabb& where, Visit&& visit) const {
        for (const Stray& stray : world_.strays.of(world_)) {
            const Proxy& proxy = world_.space[stray.proxy];
            if (!proxy.alive || !world_.bodies.record[proxy.owner].enabled) continue;
            if (world_.def.wrap.any())
                world_.space.forEachShift(where, stray.box, [&](const Vec2& shift) { visit(stray, shift); });
            else
                visit(stray, Vec2(0, 0));
        }
    }

    const WorldState& world_;
    Gate gate_;
    BodyIndex ignored_;
    bool outlines_ = false;
};

}  // namespace plumb
