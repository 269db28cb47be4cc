// SPDX-License-Identifier: MIT
// Have two shapes that are apart at the end of a step met within it?
#pragma once
#include <plumb/dynamics/sensors/body_paths.h>
#include <plumb/dynamics/sensors/sensor_store.h>

namespace plumb {

/// separation: the distance of the two shapes now [m].
bool haveMet(const SensorPair& pair, double separation, const Space& space, BodyPaths& paths);

}  // namespace plumb
