// SPDX-License-Identifier: MIT
// Where is a body between two ticks?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>
#include <plumb/stepping/interpolate.h>

namespace plumb::games {

/// Remembers the poses of the bodies of a world before a tick, so that they can be drawn moving smoothly.
class PoseTrail {
public:
    void keep(const World& world);  ///< call it before the world's step

    /// The pose of a body of that world, by Canvas.between(): 0 gives the kept pose, 1 the current one. A body that was
    /// not there at keep() gets its current pose. In a world that wraps, the body takes the shorter way.
    Transform pose(const World& world, BodyId body, double between) const;

private:
    struct Kept {
        BodyId body;
        Transform pose;
    };
    std::vector<Kept> kept_;  ///< by the bodies' slots
};

inline void PoseTrail::keep(const World& world) {
    kept_.clear();
    for (const BodyId id : world.bodies()) {
        if (kept_.size() <= id.index) kept_.resize(id.index + std::size_t{1});
        kept_[id.index] = {id, world.body(id).pose()};
    }
}

inline Transform PoseTrail::pose(const World& world, BodyId body, double between) const {
    Transform now = world.body(body).pose();
    if (body.index >= kept_.size() || kept_[body.index].body != body) return now;
    const Transform& before = kept_[body.index].pose;
    now.position += world.wrap().shiftNear(now.position, before.position);
    return interpolate(before, now, between);
}

}  // namespace plumb::games
