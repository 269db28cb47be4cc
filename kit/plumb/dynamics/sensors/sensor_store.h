// SPDX-License-Identifier: MIT
// Which shapes are near a sensor, and which ones are in it?
#pragma once
#include <vector>

#include <plumb/dynamics/events.h>
#include <plumb/math/vec2.h>
#include <plumb/space/detail/space.h>

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

}  // namespace plumb
