// SPDX-License-Identifier: MIT
// What is near sensors, and what was in them at the last step's end?
#pragma once
#include <vector>

#include <plumb/dynamics/events.h>
#include <plumb/space/space.h>

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

}  // namespace plumb
