// SPDX-License-Identifier: MIT
#include <compare/mover/parts.h>

#include <algorithm>

#include <compare/scene/joint_geometry.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

/// With this slack, a cue at a tick's time applies to that tick, even if the times are rounded [s].
constexpr double slack = 1e-9;

}  // namespace

Vec2 placeOn(const PathMover& path, double delay, int step, double dt) {
    return path.at(std::max(0.0, step * dt - delay)).position;
}

Vec2 placeOn(const SwingMotion& swing, const Vec2& start, int step, double dt) {
    return start + swing.amplitude * sinCos(swing.rate * step * dt).sin;
}

GridMover gridMoverOf(const GridMotion& motion) {
    return GridMover({.cell = motion.cell, .heading = motion.heading});
}

PlatformProfile profileOf(const PlatformMotion& motion) {
    return motion.profile == PlatformStyle::Of1985 ? profile1985() : modernProfile();
}

PlacedMap PlacedMaps::of(const Scene& scene, const GridMotion& motion) {
    const auto found = maps_.find(motion.map);
    if (found != maps_.end()) return found->second;
    const BodyDef& body = scene.bodies[bodyIndex(scene, motion.map)].def;
    const auto map = std::make_shared<const TileMap>(std::get<TileMap>(body.shapes.front().shape));
    return maps_[motion.map] = {map, startPose(body)};
}

PlatformCue cueAt(const PlatformMotion& motion, double time) {
    PlatformCue held;
    for (const PlatformCue& cue : motion.cues)
        if (cue.time <= time + slack) held = cue;
    return held;
}

void TurnList::ask(GridMover& mover) {
    if (turns_.empty()) return;
    if (mover.heading() == turns_[next_]) next_ = (next_ + 1) % turns_.size();
    mover.want(turns_[next_]);
}

}  // namespace plumb::compare
