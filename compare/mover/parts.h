// SPDX-License-Identifier: MIT
// What do the kit's movers and what stands in for them make of a scene's movers alike?
#pragma once
#include <map>
#include <memory>
#include <string>

#include <compare/scene/scene.h>
#include <plumb/movers/grid_mover.h>
#include <plumb/movers/path_mover.h>
#include <plumb/movers/platform_profile.h>

namespace plumb::compare {

PathMover pathMoverOf(const PathMotion& motion);
/// Where it is after a step, the so-manieth from 1 on.
Vec2 placeOn(const PathMover& path, double delay, int step, double dt);
/// The same of what swings about a place.
Vec2 placeOn(const SwingMotion& swing, const Vec2& start, int step, double dt);
GridMover gridMoverOf(const GridMotion& motion);
PlatformProfile profileOf(const PlatformMotion& motion);

/// The map of a grid motion, and where its frame is; all movers on a map share it.
struct PlacedMap {
    std::shared_ptr<const TileMap> map;
    Transform pose;
};
class PlacedMaps {
public:
    PlacedMap of(const Scene& scene, const GridMotion& motion);

private:
    std::map<std::string, PlacedMap> maps_;
};

/// What is held at a time; nothing before the first cue [s].
PlatformCue cueAt(const PlatformMotion& motion, double time);

/// Wants one turn after the other of a grid mover, round and round.
class TurnList {
public:
    explicit TurnList(const GridMotion& motion) : turns_(motion.turns) {}
    void ask(GridMover& mover);

private:
    std::vector<Direction> turns_;
    std::size_t next_ = 0;
};

}  // namespace plumb::compare
