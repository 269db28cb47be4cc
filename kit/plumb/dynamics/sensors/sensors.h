// SPDX-License-Identifier: MIT
// What has come into a sensor in this step, and what has left one?
#pragma once
#include <plumb/broad/pair.h>
#include <plumb/dynamics/bodies/trajectory.h>
#include <plumb/dynamics/sensors/sensor_store.h>

namespace plumb {

/// Of two shapes of which one is a sensor, and whose bounds have come to overlap; shift: of the second [m].
void addSensorPair(SensorStore& sensors, const Space& space, const Pair& pair, const Vec2& shift);
/// Forgets what a shape is near. An end event follows from the next step, unless it is found there again.
void removeSensorPairs(SensorStore& sensors, ProxyId proxy);
/// To be called when all bodies have their new places. Looks at pairs of which a body is awake, and at new ones.
void watchSensors(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                  double dt);

}  // namespace plumb
