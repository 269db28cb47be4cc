// SPDX-License-Identifier: MIT
// What has come into a sensor in this step, and what has left one?
#pragma once
#include <plumb/broad/pair.h>
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/events.h>
#include <plumb/space/space.h>
#include <vector>

namespace plumb {

/// A sensor, or a piece of one, and a shape whose boxes overlap.
struct SensorPair {
    ProxyId sensor = 0, visitor = 0;
    Vec2 shift{0, 0};  ///< so many rounds of the world bring the visitor to the sensor [m]
    bool inside = false;
    bool fresh = true;  ///< never looked at
};

struct SensorStore {
    std::vector<SensorPair> pairs;
    std::vector<SensorBegin> inside;  ///< sorted, each once, however many pieces overlap
    bool changed = false;             ///< inside may be out of date
    std::vector<SensorBegin> begins;
    std::vector<SensorEnd> ends;
};

/// Of two shapes of which one is a sensor, and whose bounds have come to overlap; shift: of the second [m].
void addSensorPair(SensorStore& sensors, const Space& space, const Pair& pair, const Vec2& shift);
/// Forgets what a shape is near. An end event follows from the next step, unless it is found there again.
void removeSensorPairs(SensorStore& sensors, ProxyId proxy);
/// To be called when all bodies have their new places. Looks at pairs of which a body is awake, and at new ones.
void watchSensors(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                  double dt);

}  // namespace plumb
