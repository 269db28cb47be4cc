// SPDX-License-Identifier: MIT
// Which shapes are where, now? The part of World that answers queries.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <plumb/collide/detail/outline.h>
#include <plumb/collide/ray_cast.h>
#include <plumb/collide/shape_cast.h>
#include <plumb/dynamics/edit/shape_pieces.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/query/shape_query.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// The most times that a query may reach around a world that wraps: for the path of a cast, and for a box or shape [-].
constexpr double mostCastPeriods = 1000, mostBoxPeriods = 60;

void requireShape(const Shape& shape, const Transform& pose, const std::string& query) {
    validate(shape, query + ": shape");
    requireFinite(pose.position, query, ": pose.position");
    const Rot& r = pose.rotation;
    const Vec2 direction(r.cos, r.sin);
    requireFinite(direction, query, ": pose.rotation");
    if (!(std::fabs(direction.squaredNorm() - 1) < 1e-6))
        refuse(query + ": pose.rotation", toText(direction) + " is not the cosine and sine of an angle");
}

void requireCast(const WorldState& world, const Shape& shape, const Transform& pose, const Vec2& shift,
                 const std::string& query) {
    requireShape(shape, pose, query);
    requireFinite(shift, query, ": shift");
    requireFewPeriods(world, {shift.cwiseMin(Vec2(0, 0)), shift.cwiseMax(Vec2(0, 0))}, mostCastPeriods,
                      query + ": shift");
    requireFewPeriods(world, aabbOf(shape, pose), mostBoxPeriods, query + ": shape");
}

/// The slot of the body that a cast leaves out; noBody if it leaves out none.
BodyIndex slotOfIgnored(const WorldState& world, BodyId ignored, const char* query) {
    if (ignored == BodyId{}) return noBody;
    requireBody(world, ignored, std::string(query) + ": ignored");
    return ignored.index;
}

std::tuple<std::uint32_t, std::uint32_t> placeOf(const ShapeId& shape) {
    return {shape.body.index, shape.number};
}

/// The order of hits. It is the same whatever the order in which they were found, also for two pieces of a chain that
/// are met at their common point.
auto rankOf(const CastHit& hit) {
    return std::tuple(hit.fraction, placeOf(hit.shape), hit.normal.x(), hit.normal.y());
}

bool isNearer(const Nearest& a, const Nearest& b) {
    const auto rank = [](const Nearest& n) {
        return std::tuple(n.separation, placeOf(n.shape), n.normal.x(), n.normal.y());
    };
    return rank(a) < rank(b);
}

/// A ray or shape that moves along a straight line, as a box around it.
struct Mover {
    Vec2 halfSize, from, to;
};

/// A cast asks the space with the box around its shape; the exact shape is compared with each candidate only.
Mover moverOf(const Shape& shape, const Transform& pose, const Vec2& shift) {
    const Aabb box = aabbOf(shape, pose);
    const Vec2 center = 0.5 * box.lower + 0.5 * box.upper;
    return {0.5 * (box.upper - box.lower), center, center + shift};
}

/// Is a hit of a tile map's area made redundant by a hit of its outline? If something begins inside a tile map and
/// touches the outline, the outline tells the direction out; the area counts only if no outline is touched.
bool isCovered(const CastHit& area, const CastHit& hit) {
    return area.shape == hit.shape && !(area.fraction > 0) && !(hit.fraction > 0);
}

/// Returns where a shape is met, if it is.
using Meet = FunctionRef<std::optional<CastPoint>(ProxyId, const Vec2&)>;

/// The first hit on the way. Outlines and areas of tile maps are kept apart, because an area counts only where its
/// outline is not touched. The fraction found so far bounds the search in the space.
std::optional<CastHit> firstHit(const ShapeQuery& query, const Mover& mover, Meet meet) {
    std::optional<CastHit> first, firstArea;
    query.visitAlong(mover.halfSize, mover.from, mover.to, [&](ProxyId id, const Vec2& shift) {
        std::optional<CastHit>& kind = query.isArea(id) ? firstArea : first;
        if (const std::optional<CastPoint> met = meet(id, shift)) {
            const CastHit hit = query.hitOf(id, shift, *met);
            if (!kind || rankOf(hit) < rankOf(*kind)) kind = hit;
        }
        return std::min(first ? first->fraction : 1.0, firstArea ? firstArea->fraction : 1.0);
    });
    if (!first || (firstArea && rankOf(*firstArea) < rankOf(*first) && !isCovered(*firstArea, *first)))
        return firstArea;
    return first;
}

/// All hits of all pieces, in order along the way.
std::vector<CastHit> allHits(const ShapeQuery& query, const Mover& mover, Meet meet) {
    std::vector<CastHit> hits, areas;
    query.visitAlong(mover.halfSize, mover.from, mover.to, [&](ProxyId id, const Vec2& shift) {
        if (const std::optional<CastPoint> met = meet(id, shift))
            (query.isArea(id) ? areas : hits).push_back(query.hitOf(id, shift, *met));
        return 1.0;
    });
    const auto covers = [](const CastHit& area) {
        return [&area](const CastHit& hit) { return isCovered(area, hit); };
    };
    const std::size_t outlines = hits.size();
    for (const CastHit& area : areas)
        if (std::none_of(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(outlines), covers(area)))
            hits.push_back(area);
    sortBy(hits, rankOf);
    return hits;
}

/// Keeps the first hit of each shape, given hits in order.
std::vector<CastHit> oneOfEach(std::vector<CastHit> hits) {
    sortOnceBy(hits, [](const CastHit& hit) { return placeOf(hit.shape); });
    sortBy(hits, rankOf);
    return hits;
}

auto meetRay(const ShapeQuery& query, const Vec2& from, const Vec2& to) {
    return
        [&](ProxyId id, const Vec2& shift) { return plumb::castRay(from, to, query.shape(id), query.pose(id, shift)); };
}

/// Treats a segment as part of a tile map's outline: it is solid only from outside, and has no inner corners.
std::optional<CastPoint> asOutline(const Segment& outline, const Transform& there, const Shape& shape,
                                   const Transform& pose, CastPoint met, bool moves) {
    const bool begins = !(met.fraction > 0);
    const Vec2 found = begins ? plumb::distance(outline, there, shape, pose).normal : met.normal;
    const std::optional<Vec2> normal = outlineNormal(outline, there.rotation.inverse() * found);
    if (!normal) return std::nullopt;
    if (!begins || !moves) met.normal = there.rotation * *normal;
    return met;
}

/// Returns how a shape meets others. Of a tile map it meets the outline; it meets the filled area only if it begins in
/// it.
auto meetShape(const ShapeQuery& query, const Shape& shape, const Transform& pose, const Vec2& shift) {
    return [&](ProxyId id, const Vec2& around) -> std::optional<CastPoint> {
        const Transform there = query.pose(id, around);
        const std::optional<CastPoint> met = plumb::castShape(shape, pose, shift, query.shape(id), there);
        if (!met) return met;
        if (query.isArea(id)) return met->fraction > 0 ? std::nullopt : met;
        if (!query.isOutline(id)) return met;
        return asOutline(std::get<Segment>(query.shape(id)), there, shape, pose, *met, !shift.isZero(0));
    };
}

/// The shapes that overlap or touch a shape.
std::vector<ShapeId> overlapping(const ShapeQuery& query, const Shape& shape, const Transform& pose) {
    std::vector<ShapeId> found;
    query.visitIn(aabbOf(shape, pose), [&](ProxyId id, const Vec2& shift) {
        if (plumb::distance(query.shape(id), query.pose(id, shift), shape, pose).separation <= 0)
            found.push_back(query.idOf(id));
    });
    sortOnceBy(found, placeOf);
    return found;
}

/// A box as a shape; a flat box becomes a segment or a point.
Shape shapeOf(const Aabb& box) {
    const Vec2 size = box.upper - box.lower;
    const bool wide = size.x() * size.x() > 0, high = size.y() * size.y() > 0;
    if (!wide && !high) return Circle{.radius = 0, .center = box.lower};
    if (!wide || !high) return Segment{box.lower, box.upper};
    return Polygon{{box.lower, {box.upper.x(), box.lower.y()}, box.upper, {box.lower.x(), box.upper.y()}}};
}

/// Calls visit(shift) for all shifts by which a shape in one box may come nearest to a shape in the other; both are no
/// larger than the world. The nearest points are within half a period of each other, and so the boxes' centres are
/// within one and a half.
template <class Visit>
void forEachNearShift(const Wrap& wrap, const Aabb& still, const Aabb& box, Visit&& visit) {
    const Vec2 middle = 0.5 * (still.lower + still.upper);
    const Vec2 shift = wrap.shiftNear(0.5 * (box.lower + box.upper), middle);
    const int x = wrap.width ? 2 : 0, y = wrap.height ? 2 : 0;
    for (int j = -y; j <= y; ++j)
        for (int i = -x; i <= x; ++i) visit(Vec2(shift + wrap.imageOffset({i, j})));
}

/// The pieces of one shape.
std::vector<ProxyId> proxiesOf(const WorldState& world, const ShapeId& id, const std::string& field) {
    requireShape(world, id, field);
    std::vector<ProxyId> proxies;
    // A map's sensor tiles are not part of its filled area, unless the whole map is a sensor.
    const std::span<const ProxyId> pieces = piecesOf(world, id.body.index, id.number);
    const bool isSensor = world.space[pieces.front()].def.sensor;
    for (const ProxyId proxy : pieces)
        if (world.space.filterKey(proxy).queried && (isSensor || !world.space[proxy].def.sensor))
            proxies.push_back(proxy);
    return proxies;
}

}  // namespace

std::optional<CastHit> World::castRay(const Vec2& from, const Vec2& to, const Filter& filter, BodyId ignored) const {
    requireFinite(from, "World.castRay: from");
    requireFinite(to, "World.castRay: to");
    requireFewPeriods(*state_, {from.cwiseMin(to), from.cwiseMax(to)}, mostCastPeriods, "World.castRay: to");
    const ShapeQuery query(*state_, filter, slotOfIgnored(*state_, ignored, "World.castRay"));
    return firstHit(query, {{0, 0}, from, to}, meetRay(query, from, to));
}

std::vector<CastHit> World::castRayAll(const Vec2& from, const Vec2& to, const Filter& filter, BodyId ignored) const {
    requireFinite(from, "World.castRayAll: from");
    requireFinite(to, "World.castRayAll: to");
    requireFewPeriods(*state_, {from.cwiseMin(to), from.cwiseMax(to)}, mostCastPeriods, "World.castRayAll: to");
    const ShapeQuery query(*state_, filter, slotOfIgnored(*state_, ignored, "World.castRayAll"));
    return oneOfEach(allHits(query, {{0, 0}, from, to}, meetRay(query, from, to)));
}

std::optional<CastHit> World::castShape(const Shape& shape, const Transform& pose, const Vec2& shift,
                                        const Filter& filter, BodyId ignored) const {
    requireCast(*state_, shape, pose, shift, "World.castShape");
    ShapeQuery query(*state_, filter, slotOfIgnored(*state_, ignored, "World.castShape"));
    query.includeOutlines();
    return firstHit(query, moverOf(shape, pose, shift), meetShape(query, shape, pose, shift));
}

std::vector<CastHit> World::castShapeAll(const Shape& shape, const Transform& pose, const Vec2& shift,
                                         const Filter& filter, BodyId ignored) const {
    requireCast(*state_, shape, pose, shift, "World.castShapeAll");
    ShapeQuery query(*state_, filter, slotOfIgnored(*state_, ignored, "World.castShapeAll"));
    query.includeOutlines();
    return oneOfEach(allHits(query, moverOf(shape, pose, shift), meetShape(query, shape, pose, shift)));
}

std::vector<CastHit> World::castShapePieces(const Shape& shape, const Transform& pose, const Vec2& shift,
                                            const Filter& filter, BodyId ignored) const {
    requireCast(*state_, shape, pose, shift, "World.castShapePieces");
    ShapeQuery query(*state_, filter, slotOfIgnored(*state_, ignored, "World.castShapePieces"));
    query.includeOutlines();
    return allHits(query, moverOf(shape, pose, shift), meetShape(query, shape, pose, shift));
}

std::vector<ShapeId> World::overlapBox(const Aabb& box, const Filter& filter) const {
    requireFinite(box.lower, "World.overlapBox: box.lower");
    requireFinite(box.upper, "World.overlapBox: box.upper");
    if (!(box.lower.x() <= box.upper.x() && box.lower.y() <= box.upper.y()))
        refuse("World.overlapBox: box.upper", toText(box.upper) + " is below box.lower " + toText(box.lower));
    requireFewPeriods(*state_, box, mostBoxPeriods, "World.overlapBox: box");
    return overlapping({*state_, filter}, shapeOf(box), {});
}

std::vector<ShapeId> World::overlapShape(const Shape& shape, const Transform& pose, const Filter& filter) const {
    requireShape(shape, pose, "World.overlapShape");
    requireFewPeriods(*state_, aabbOf(shape, pose), mostBoxPeriods, "World.overlapShape: shape");
    return overlapping({*state_, filter}, shape, pose);
}

std::vector<ShapeId> World::overlapPoint(const Vec2& point, const Filter& filter) const {
    requireFinite(point, "World.overlapPoint: point");
    return overlapping({*state_, filter}, Circle{.radius = 0}, {point, {}});
}

/// What was found bounds the rest of the search. Within a shape the separation is negative; then all shapes at the
/// point are compared, so that the deepest is named, whatever the order in which the space has them.
std::optional<Nearest> World::nearest(const Vec2& point, double within, const Filter& filter) const {
    requireFinite(point, "World.nearest: point");
    if (!(within >= 0)) refuse("World.nearest: within", toText(within) + " is not a distance");
    const ShapeQuery query(*state_, filter);
    std::optional<Nearest> nearest;
    query.visitNear(point, within, [&](ProxyId id, const Vec2& shift) {
        const Transform pose = query.pose(id, shift);
        const Distance d = plumb::distance(query.shape(id), pose, Circle{.radius = 0}, {point, {}});
        const Nearest here{query.idOf(id), d.separation, query.place(d.pointA), d.normal};
        if (d.separation <= within && (!nearest || isNearer(here, *nearest))) nearest = here;
        return nearest ? std::max(nearest->separation, 0.0) : within;
    });
    return nearest;
}

/// O(pieces of a x pieces of b): meant for shapes of few pieces. For a point and a large map, nearest() asks the space.
Distance World::distance(ShapeId a, ShapeId b) const {
    const WorldState& world = *state_;
    const std::vector<ProxyId> piecesA = proxiesOf(world, a, "World.distance: a");
    const std::vector<ProxyId> piecesB = proxiesOf(world, b, "World.distance: b");
    const Transform poseA = world.bodies.pose(a.body.index), poseB = world.bodies.pose(b.body.index);
    Distance nearest;
    nearest.separation = std::numeric_limits<double>::infinity();
    for (const ProxyId pieceA : piecesA) {
        for (const ProxyId pieceB : piecesB) {
            const Shape& shapeA = world.space[pieceA].def.shape;
            const Shape& shapeB = world.space[pieceB].def.shape;
            forEachNearShift(world.bodies.wrap, aabbOf(shapeA, poseA), aabbOf(shapeB, poseB), [&](const Vec2& shift) {
                const Distance here = plumb::distance(shapeA, poseA, shapeB, shifted(poseB, shift));
                if (here.separation < nearest.separation) nearest = here;
            });
        }
    }
    nearest.pointA = world.bodies.wrap.place(nearest.pointA);
    nearest.pointB = world.bodies.wrap.place(nearest.pointB);
    return nearest;
}

}  // namespace plumb
