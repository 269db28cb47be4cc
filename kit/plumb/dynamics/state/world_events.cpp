// SPDX-License-Identifier: MIT
#include <plumb/dynamics/state/world_events.h>

namespace plumb {

namespace {

ContactBegin beginOf(const ShapeTouch& touch, const BodyStore& bodies, const Space& space, const TileStore& tiles) {
    const MetTile tile{touch.proxyA, touch.proxyB, touch.shift, touch.point, touch.normal};
    return {idOfShape(bodies, space[touch.proxyA]),
            idOfShape(bodies, space[touch.proxyB]),
            bodies.wrap.place(touch.point),
            touch.normal,
            touch.approachSpeed,
            tileTouched(tiles, bodies, space, tile)};
}

ContactHit hitOf(const ContactBegin& begin) {
    return {begin.shapeA, begin.shapeB, begin.point, begin.normal, begin.approachSpeed, begin.tile};
}

}  // namespace

/// Ends that edits have added since the last step belong to the next report, so only those that were reported go.
void WorldEvents::clear() {
    begins.clear();
    breaks.clear();
    hits.clear();
    quarantines.clear();
    sleepers.clear();
    ends.erase(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(reportedEnds));
}

void WorldEvents::add(const TouchEvents& touches, const BodyStore& bodies, const Space& space, const TileStore& tiles) {
    for (const ShapeTouch& touch : touches.begins) begins.push_back(beginOf(touch, bodies, space, tiles));
    for (const ShapeTouch& touch : touches.hits) hits.push_back(hitOf(beginOf(touch, bodies, space, tiles)));
    addEnds(touches.ends, bodies, space);
}

void WorldEvents::addEnds(std::span<const TouchEnd> touchEnds, const BodyStore& bodies, const Space& space) {
    for (const TouchEnd& end : touchEnds)
        ends.push_back({idOfShape(bodies, space[end.proxyA]), idOfShape(bodies, space[end.proxyB])});
}

}  // namespace plumb
