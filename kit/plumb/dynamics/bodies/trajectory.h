// SPDX-License-Identifier: MIT
// Where has a body been that had impacts in this step?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// From one impact to the next.
struct TrajectorySegment {
    BodyIndex body = noBody;
    BodyMotion from, to;
    double start = 0, end = 0;  ///< in the step [s]
};

/// Each body's segments in the order of time.
using Trajectories = std::vector<TrajectorySegment>;

}  // namespace plumb
