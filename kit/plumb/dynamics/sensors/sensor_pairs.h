// SPDX-License-Identifier: MIT
// Which shapes are near a sensor, which ones are in it, and which pairs that are apart at the end of a step have met
// within it?
//
// A shape's bounds contain its predicted path, and pairs are those whose bounds overlap. A body that was struck, pushed
// or pulled in the step may leave its bounds: such pairs are found from the paths.
#pragma once
#include <vector>

#include <plumb/dynamics/events.h>
#include <plumb/dynamics/sensors/body_paths.h>
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

/// separation: the distance of the two shapes now [m].
bool haveMet(const SensorPair& pair, double separation, const Space& space, BodyPaths& paths);

/// Pairs whose bounds do not overlap, though the boxes of their paths do. They are for this step only: if the two stay
/// near each other, the next step finds them in any case. In a world that wraps, what moves farther than a period in
/// the step is left out, see predictedShift.
std::vector<SensorPair> findDeflectedPairs(const SensorStore& sensors, const BodyStore& bodies, const Space& space,
                                           BodyPaths& paths);

}  // namespace plumb
