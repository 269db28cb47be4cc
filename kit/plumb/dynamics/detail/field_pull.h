// SPDX-License-Identifier: MIT
// What do the fields do to a body where it is?
#pragma once
#include <vector>

#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Drag by the square of the speed, per mass.
struct SpeedDrag {
    double rate = 0;  ///< [1/m]
    Vec2 flow{0, 0};  ///< [m/s]
};

/// dv/dt = acceleration - linear v + flow - sum of rate |v - w| (v - w), and friction against v; turning likewise.
struct FieldPull {
    Acceleration acceleration;       ///< all of it
    Acceleration unaccounted;        ///< of that: what has no potential energy
    double linear = 0, turning = 0;  ///< [1/s]
    Vec2 flow{0, 0};                 ///< sum of each linear rate times its flow [m/s^2]
    std::vector<SpeedDrag> quadratic;
    double friction = 0, spinFriction = 0;  ///< [m/s^2, rad/s^2]
};

/// now: where each body is, by its slot.
FieldPull pullOn(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now);

/// Of all fields that have one [J].
double fieldEnergyOf(const WorldState& world);
/// Of one body, if it were there, and all others where they are.
double fieldEnergyOf(const WorldState& world, BodyIndex body, const BodyMotion& there);

/// Before a step: what mutual gravity or a magnet that is awake draws is not to sleep.
void wakeWhatIsDrawn(WorldState& world);

/// Before a field comes, changes or goes.
void wakeWhatFeels(WorldState& world, const FieldRecord& field);

}  // namespace plumb
