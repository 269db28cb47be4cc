// SPDX-License-Identifier: MIT
// Which shapes have entered a sensor in this step, and which ones have left one?
#pragma once
#include <vector>

#include <plumb/broad/pair.h>
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/events.h>
#include <plumb/space/space.h>

namespace plumb {

/// A sensor, or a piece of one, and another shape, the visitor, whose bounds overlap.
struct SensorPair {
    ProxyId sensor = 0, visitor = 0;
    Vec2 shift{0, 0};  ///< whole periods of the world that bring the visitor near the sensor [m]
    bool inside = false;
    bool fresh = true;  ///< not checked yet
};

struct SensorStore {
    std::vector<ProxyId> sensors;  ///< all sensors and pieces of sensors, sorted
    std::vector<SensorPair> pairs;
    std::vector<SensorBegin> inside;  ///< sorted; a visit is in it once, even if several pieces overlap
    bool changed = false;             ///< inside may be out of date
    std::vector<SensorBegin> begins;
    std::vector<SensorEnd> ends;
};

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
