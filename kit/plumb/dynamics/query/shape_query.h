// SPDX-License-Identifier: MIT
// Which shapes may a query with a filter find?
#pragma once
#include <plumb/collide/ray_cast.h>
#include <plumb/dynamics/query.h>
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Finds candidates by their boxes, at the positions after the last step and all calls since. It finds all shapes that
/// may match, some that do not, and some twice.
class ShapeQuery {
public:
    ShapeQuery(const WorldState& world, const Filter& filter, BodyIndex ignored = noBody)
        : world_(world), filterKey_{filter.category, filter.mask, 0, filter.group}, ignored_(ignored) {}

    /// From now on also finds the outlines of tile maps, which otherwise are found by their areas.
    void includeOutlines() { outlines_ = true; }
    /// Is this piece part of a tile map's outline (isOutline), or of the area that it fills (isArea)?
    bool isOutline(ProxyId id) const { return world_.space[id].use == PieceUse::Contact; }
    bool isArea(ProxyId id) const { return world_.space[id].use == PieceUse::Query; }

    const Shape& shape(ProxyId id) const { return world_.space[id].def.shape; }
    /// The pose of the image that was found, in a world that wraps.
    Transform pose(ProxyId id, const Vec2& shift) const {
        return shifted(world_.bodies.pose(world_.space[id].owner), shift);
    }
    Vec2 place(const Vec2& point) const { return world_.bodies.wrap.place(point); }
    ShapeId idOf(ProxyId id) const { return world_.idOfShape(id); }
    CastHit hitOf(ProxyId id, const Vec2& shift, const CastPoint& met) const {
        CastHit hit{idOf(id), place(met.point), met.normal, met.fraction};
        if (const std::optional<Vec2>& open = world_.space[id].def.oneWay)
            hit.oneWay = pose(id, shift).rotation * *open;
        hit.tile = tileMet(world_.tiles, world_.bodies, world_.space, id, met.point - shift, met.normal);
        return hit;
    }

    /// Visits all shapes that a box of this half size may meet on its way. visit(id, shift) returns the fraction of the
    /// way up to which further shapes are wanted.
    void visitAlong(const Vec2& halfSize, const Vec2& from, const Vec2& to, Space::VisitWhile visit) const;

    /// Visits all shapes that may be no farther from a point than within [m]. visit(id, shift) returns the distance up
    /// to which further shapes are wanted.
    void visitNear(const Vec2& point, double within, Space::VisitWhile visit) const;

    /// Visits all shapes that may be in a box.
    void visitIn(const Aabb& tight, Space::Visit visit) const;

private:
    bool matches(ProxyId id) const {
        const FilterKey& filterKey = world_.space.filterKey(id);
        return filtersAllow(filterKey_, filterKey) && (filterKey.queried || (outlines_ && filterKey.collides)) &&
               !filterKey.sensor && filterKey.owner != ignored_;
    }
    /// Visits shapes whose bounds in the space are out of date, with each shift by which they may be in a box; with a
    /// shift of 0 in a world that does not wrap.
    void forEachStale(const Aabb& where, FunctionRef<void(const StaleBound&, const Vec2&)> visit) const;

    const WorldState& world_;
    FilterKey filterKey_;
    BodyIndex ignored_;
    bool outlines_ = false;
};

}  // namespace plumb
