// SPDX-License-Identifier: MIT
// Which shapes have entered a sensor in this step, and which ones have left one?
#pragma once
#include <plumb/broad/pair.h>
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/sensors/sensor_pairs.h>

namespace plumb {

/// Notes a new sensor, or a piece of one.
void addSensor(SensorStore& sensors, ProxyId sensor);
/// Forgets a shape that is removed, if it is a sensor.
void forgetSensor(SensorStore& sensors, ProxyId proxy);
/// Adds a pair of two shapes whose bounds overlap and of which one is a sensor; shift belongs to the second [m].
void addSensorPair(SensorStore& sensors, const Space& space, const Pair& pair, const Vec2& shift);
/// Removes all pairs of a shape. The next step makes the end events, unless it finds the pairs again.
void removeSensorPairs(SensorStore& sensors, ProxyId proxy);
/// Finds the begin and end events of a step. Call this when all bodies have their new places. It checks new pairs,
/// pairs with an awake body, and what has met outside of the bounds for which pairs were made.
void watchSensors(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                  double dt);

}  // namespace plumb
