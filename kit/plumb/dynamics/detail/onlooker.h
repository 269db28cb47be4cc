// SPDX-License-Identifier: MIT
// Which shapes are there to be found, for whoever looks through a filter?
#pragma once
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
    Transform pose(ProxyId id) const { return world_.bodies.pose(world_.space[id].owner); }
    ShapeId idOf(ProxyId id) const { return world_.idOfShape(id); }
    CastHit hitOf(ProxyId id, const CastPoint& met) const {
        CastHit hit{idOf(id), met.point, met.normal, met.fraction};
        if (const std::optional<Vec2>& open = world_.space[id].def.oneWay) hit.oneWay = pose(id).rotation * *open;
        hit.tile = tileMet(world_, id, met.point, met.normal);
        return hit;
    }

    /// Whatever a box of this half size may meet on its way; visit(id) gives the fraction of it up to which more is
    /// wanted.
    template <class Visit>
    void lookAlong(const Vec2& halfSize, const Vec2& from, const Vec2& to, Visit&& visit) const {
        double wanted = 1;
        const auto look = [&](ProxyId id) {
            if (sees(id)) wanted = visit(id);
            return wanted;
        };
        world_.space.castBox(halfSize, from, to, look);
        forEachStray([&](const Stray& stray) {
            const RayPart met = clipRay(from, to, {stray.box.lower - halfSize, stray.box.upper + halfSize});
            if (met.first <= met.last) look(stray.proxy);
        });
    }

    /// Whatever may be no farther from a point than within; visit(id) gives the distance up to which more is wanted.
    template <class Visit>
    void lookAround(const Vec2& point, double within, Visit&& visit) const {
        const auto look = [&](ProxyId id) {
            if (sees(id)) within = visit(id);
            return within;
        };
        world_.space.findNear(point, within, look);
        forEachStray([&](const Stray& stray) { look(stray.proxy); });
    }

    /// Whatever may be in a box.
    template <class Visit>
    void lookInto(const Aabb& tight, Visit&& visit) const {
        // What just touches is not to be lost to roundings.
        const Aabb box = inflate(tight, 1e-15 * tight.lower.cwiseAbs().cwiseMax(tight.upper.cwiseAbs()).maxCoeff());
        const auto look = [&](ProxyId id) {
            if (sees(id)) visit(id);
        };
        world_.space.query(box, look);
        forEachStray([&](const Stray& stray) {
            if (overlap(stray.box, box)) look(stray.proxy);
        });
    }

private:
    bool sees(ProxyId id) const {
        const Gate& gate = world_.space.gate(id);
        return mayMeet(gate_, gate) && (gate.asked || (outlines_ && gate.touched)) && !gate.sensor &&
               gate.owner != ignored_;
    }

    template <class Visit>
    void forEachStray(Visit&& visit) const {
        for (const Stray& stray : world_.strays.of(world_)) {
            const Proxy& proxy = world_.space[stray.proxy];
            if (proxy.alive && world_.bodies.record[proxy.owner].enabled) visit(stray);
        }
    }

    const WorldState& world_;
    Gate gate_;
    BodyIndex ignored_;
    bool outlines_ = false;
};

}  // namespace plumb
