// SPDX-License-Identifier: MIT
// What do the kit's movers and the replacements for them in other engines share?
#pragma once
#include <map>
#include <memory>
#include <string>

#include <compare/scene/scene.h>
#include <plumb/movers/grid_mover.h>
#include <plumb/movers/path_mover.h>
#include <plumb/movers/platform_profile.h>

namespace plumb::compare {

/// The mover's place after a step. Steps are counted from 1.
Vec2 placeOn(const PathMover& path, double delay, int step, double dt);
/// The same for a body that swings about a place.
Vec2 placeOn(const SwingMotion& swing, const Vec2& start, int step, double dt);
GridMover gridMoverOf(const GridMotion& motion);
PlatformProfile profileOf(const PlatformMotion& motion);

/// The map of a grid motion, and the pose of its frame. All movers on a map share it.
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

/// The cue that applies at a time [s]; an empty cue before the first one.
PlatformCue cueAt(const PlatformMotion& motion, double time);

/// Asks a grid mover for one turn after the other; after the last one, it starts again.
class TurnList {
public:
    explicit TurnList(const GridMotion& motion) : turns_(motion.turns) {}
    void ask(GridMover& mover);

private:
    std::vector<Direction> turns_;
    std::size_t next_ = 0;
};

}  // namespace plumb::compare
