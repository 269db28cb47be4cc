// SPDX-License-Identifier: MIT
// Where is a body between two ticks?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb::games {

/// Remembers where the bodies of a world were before a tick, so that they are drawn moving smoothly.
class PoseTrail {
public:
    void keep(const World& world);  ///< before its step

    /// Of a body of that world, by Canvas.between(): 0 where it was kept, 1 where it is; where it is, if it was not
    /// there. The nearest way round in a world that wraps.
    Transform pose(const World& world, BodyId body, double between) const;

private:
    struct Kept {
        BodyId body;
        Transform pose;
    };
    std::vector<Kept> kept_;  ///< by the bodies' slots
};

}  // namespace plumb::games
