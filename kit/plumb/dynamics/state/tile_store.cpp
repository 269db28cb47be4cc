// SPDX-License-Identifier: MIT
#include <plumb/dynamics/state/tile_store.h>

#include <algorithm>
#include <cmath>

#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

/// Share of a cell by which a point is moved into the shape it lies on: more than rounding, less than any tile [-].
constexpr double inward = 1e-6;

/// The outward direction of a piece. A segment of an outline has the filled side on its left, on whichever side it was
/// met; a one-way tile is met only at its top.
Vec2 outwardOf(const Proxy& piece, const Vec2& normal) {
    if (piece.def.oneWay) return *piece.def.oneWay;
    const auto* stretch = std::get_if<Segment>(&piece.def.shape);
    if (stretch == nullptr) return normal;
    const Vec2 along = (stretch->end - stretch->start).normalized();
    return {along.y(), -along.x()};
}

/// A contact point lies halfway between the two surfaces, so slightly off the map's surface: on a slope it may lie in
/// the next row. This moves it onto the surface.
Vec2 ontoSurface(const Proxy& piece, const Vec2& point) {
    const auto* stretch = std::get_if<Segment>(&piece.def.shape);
    if (stretch == nullptr) return point;
    const Vec2 along = stretch->end - stretch->start;
    const double share = std::clamp(along.dot(point - stretch->start) / along.squaredNorm(), 0.0, 1.0);
    return stretch->start + share * along;
}

/// The index of a cell along one axis, kept within those that the piece covers: a point at a piece's end belongs to its
/// last cell, and rounding must not name the one behind it.
int cellIn(double value, double lower, double upper, double size) {
    const auto index = [size](double x) { return static_cast<int>(std::floor(x / size)); };
    const int first = index(lower + inward * size), last = index(upper - inward * size);
    return std::clamp(index(value), std::min(first, last), std::max(first, last));
}

}  // namespace

/// A point on an outline lies between two cells, the filled one and the empty one before it. It is moved a little
/// inward, against the outward direction, so that it names the filled one.
std::optional<Cell> tileMet(const TileStore& tiles, const BodyStore& bodies, const Space& space, ProxyId piece,
                            const Vec2& point, const Vec2& normal) {
    const Proxy& proxy = space[piece];
    if (!proxy.piece) return std::nullopt;
    const auto found = tiles.find({proxy.owner, proxy.number});
    if (found == tiles.end()) return std::nullopt;
    const Transform pose = bodies.pose(proxy.owner);
    const Rot back = pose.rotation.inverse();
    const double size = found->second.map().size();
    const Vec2 out = outwardOf(proxy, back * normal);
    const Vec2 local = ontoSurface(proxy, back * Vec2(point - pose.position)) - out * (inward * size);
    const Aabb box = aabbOf(proxy.def.shape, {});
    const double lower = proxy.def.oneWay ? box.lower.y() - inward * size : box.lower.y();
    return Cell{cellIn(local.x(), box.lower.x(), box.upper.x(), size), cellIn(local.y(), lower, box.upper.y(), size)};
}

std::optional<Cell> tileTouched(const TileStore& tiles, const BodyStore& bodies, const Space& space,
                                const MetTile& where) {
    const std::optional<Cell> ofA = tileMet(tiles, bodies, space, where.proxyA, where.point, where.normal);
    return ofA ? ofA : tileMet(tiles, bodies, space, where.proxyB, where.point - where.shift, -where.normal);
}

}  // namespace plumb
