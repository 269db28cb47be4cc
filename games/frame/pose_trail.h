// SPDX-License-Identifier: MIT
// Where is a body between two ticks?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>

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

}  // namespace plumb::games
