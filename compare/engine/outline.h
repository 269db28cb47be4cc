// SPDX-License-Identifier: MIT
// Which points describe a shape for an engine that has no such shape?
#pragma once
#include <fmt/format.h>

#include <string>
#include <vector>

#include <compare/engine/engine.h>
#include <plumb/shapes/shape.h>

namespace plumb::compare {

/// The points of an open chain, with one more point before its start and one after its end, in a straight line. Engines
/// with one-sided chains need these neighbours.
inline std::vector<Vec2> withGhosts(const Chain& chain) {
    const std::vector<Vec2>& points = chain.points;
    std::vector<Vec2> result;
    result.reserve(points.size() + 2);
    result.push_back(2 * points[0] - points[1]);
    result.insert(result.end(), points.begin(), points.end());
    result.push_back(2 * points[points.size() - 1] - points[points.size() - 2]);
    return result;
}

/// A segment with its neighbours. A neighbour that it does not name is added in a straight line.
inline std::vector<Vec2> withGhosts(const Segment& segment) {
    const Vec2 along = segment.end - segment.start;
    return {segment.before.value_or(segment.start - along), segment.start, segment.end,
            segment.after.value_or(segment.end + along)};
}

/// Is the shape a polygon with a radius? Its mass differs between engines.
inline bool isRounded(const Shape& shape) {
    const auto* polygon = std::get_if<Polygon>(&shape);
    return polygon && polygon->radius > 0;
}

inline bool hasNeighbour(const Segment& segment) {
    return segment.before || segment.after;
}

/// The rectangle along a capsule's axis that reaches halfWidth to either side, counter-clockwise.
inline Polygon axisBox(const Capsule& capsule, double halfWidth) {
    const Vec2 along = (capsule.end - capsule.start).normalized();
    const Vec2 left = halfWidth * Vec2(-along.y(), along.x());
    return {{capsule.start - left, capsule.end - left, capsule.end + left, capsule.start + left}};
}

/// The polygon of each solid tile of a map, in the body's frame. Throws Unsupported for tiles of another kind.
inline std::vector<Polygon> tilePolygons(const TileMap& map, const std::string& body) {
    std::vector<Polygon> polygons;
    for (int row = 0; row < map.rows(); ++row) {
        for (int column = 0; column < map.columns(); ++column) {
            const Tile tile = map.at({column, row});
            if (isEmpty(tile)) continue;
            if (!isSolid(tile))
                throw Unsupported(fmt::format("body {}: tiles that are sensors or solid one way are not given", body));
            polygons.push_back({map.cornersOf({column, row})});
        }
    }
    return polygons;
}

}  // namespace plumb::compare
