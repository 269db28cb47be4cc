// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_probe.h>

#include <tuple>

#include <plumb/collide/shape_cast.h>
#include <plumb/math/detail/sorting.h>

namespace plumb::detail {

namespace {

/// One body, one map, one straight part of its motion.
struct Passage {
    const TileMap& map;
    ShapeId shape;
    Transform pose;  ///< of the map, at the image nearest to the body
    Vec2 shift;      ///< motion of the body
};

bool isHazard(const Tile& tile) {
    return !isEmpty(tile) && tile.kind == TileKind::Hazard;
}

/// around: the body's shape, enlarged by the distance that counts as touching.
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

/// The pose of a map after the step; in a world that wraps, the image nearest to a point.
Transform poseOf(const SlideProbe& probe, const ShapeId& shape, const TileMap& map, const Vec2& near) {
    const MovingBody* other = probe.find(shape.body);
    Transform pose = probe.world().body(shape.body).pose();
    if (other != nullptr) pose = other->undoStep.inverse() * pose;
    const Vec2 middle = pose * Vec2(0.5 * map.size() * Vec2(map.columns(), map.rows()));
    pose.position += probe.world().wrap().shiftNear(middle, near);
    return pose;
}

auto placeOf(const TileTouch& touch) {
    return std::tuple(touch.shape.body.index, touch.shape.number, touch.tile.row, touch.tile.column);
}

}  // namespace

std::vector<TileTouch> hazardsOn(const SlideProbe& probe, std::span<const Vec2> path) {
    std::vector<TileTouch> touched;
    for (const ShapeId& shape : probe.hitMaps()) {
        const TileMap* map = mapOf(probe.world(), shape);
        for (std::size_t i = 0; map != nullptr && i < path.size(); ++i) {
            const Vec2 shift = i + 1 < path.size() ? Vec2(path[i + 1] - path[i]) : Vec2(0, 0);
            const Passage passage{*map, shape, poseOf(probe, shape, *map, path[i]), shift};
            probe.forEachShape(path[i], 1.5, [&](const Shape& around, const Transform& from) {
                addTouched(touched, passage, around, from);
            });
        }
    }
    sortOnceBy(touched, placeOf);
    return touched;
}

}  // namespace plumb::detail
