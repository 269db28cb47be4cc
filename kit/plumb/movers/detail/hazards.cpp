// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/hazards.h>

#include <algorithm>
#include <tuple>

#include <plumb/collide/shape_cast.h>

namespace plumb::detail {

namespace {

/// One body, one map, one stretch of the way.
struct Passage {
    const TileMap& map;
    ShapeId shape;
    Transform pose;  ///< of the map, where the body is near it
    Vec2 shift;      ///< of the body
};

bool isHazard(const Tile& tile) {
    return !isEmpty(tile) && tile.kind == TileKind::Hazard;
}

/// around: the body's shape, and all that is so near to it that it counts as touched.
void addTouched(std::vector<TileTouch>& touched, const Passage& passage, const Shape& around, const Transform& from) {
    const Transform there = passage.pose.inverse() * from;
    const Vec2 shift = passage.pose.rotation.inverse() * passage.shift;
    const Aabb box = aabbOf(around, there);
    const Cell first = passage.map.cellAt(box.lower + shift.cwiseMin(0.0));
    const Cell last = passage.map.cellAt(box.upper + shift.cwiseMax(0.0));
    for (int row = first.row; row <= last.row; ++row) {
        for (int column = first.column; column <= last.column; ++column) {
            const Cell cell{column, row};
            if (!isHazard(passage.map.at(cell))) continue;
            if (castShape(around, there, shift, Polygon{passage.map.cornersOf(cell)}, {}))
                touched.push_back({passage.shape, passage.map.wrapped(cell)});
        }
    }
}

auto placeOf(const TileTouch& touch) {
    return std::tuple(touch.shape.body.index, touch.shape.number, touch.tile.row, touch.tile.column);
}

}  // namespace

std::vector<TileTouch> hazardsOn(const SlideProbe& probe, std::span<const Vec2> way) {
    std::vector<TileTouch> touched;
    for (const ShapeId& shape : probe.mapsMet()) {
        const TileMap* map = mapOf(probe.world(), shape);
        for (std::size_t i = 0; map != nullptr && i < way.size(); ++i) {
            const Vec2 shift = i + 1 < way.size() ? Vec2(way[i + 1] - way[i]) : Vec2(0, 0);
            const Passage passage{*map, shape, probe.poseOfMap(shape, *map, way[i]), shift};
            probe.forEachShape(way[i], 1.5, [&](const Shape& around, const Transform& from) {
                addTouched(touched, passage, around, from);
            });
        }
    }
    std::ranges::sort(touched, {}, placeOf);
    const auto again = std::ranges::unique(touched, {}, placeOf);
    touched.erase(again.begin(), again.end());
    return touched;
}

}  // namespace plumb::detail
