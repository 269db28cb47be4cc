// SPDX-License-Identifier: MIT
// What has come into a sensor in this step, and what has left one?
#pragma once
#include <plumb/broad/pair.h>
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Of two shapes of which one is a sensor, and whose boxes have come to overlap.
void addSensorPair(WorldState& world, const Pair& pair, const Vec2& shift);
/// Forgets what a shape is near. An end event follows from the next step, unless it is found there again.
void removeSensorPairs(WorldState& world, ProxyId proxy);
/// To be called when all bodies have their new places. Looks at pairs of which a body is awake, and at new ones.
void watchSensors(WorldState& world, double dt);

}  // namespace plumb
