// SPDX-License-Identifier: MIT
// Which sensors and visitors may have met outside of the bounds for which the pairs of a step were made?
//
// A shape's bounds contain its predicted path. A body that was struck, pushed or pulled in the step may leave them.
#pragma once
#include <vector>

#include <plumb/dynamics/sensors/body_paths.h>
#include <plumb/dynamics/sensors/sensor_store.h>

namespace plumb {

/// Pairs whose bounds do not overlap, though the boxes of their paths do. They are for this step only: if the two stay
/// near each other, the next step finds them in any case. In a world that wraps, what moves farther than a period in
/// the step is left out, see predictedShift.
std::vector<SensorPair> findStrayPairs(const SensorStore& sensors, const BodyStore& bodies, const Space& space,
                                       BodyPaths& paths);

}  // namespace plumb
