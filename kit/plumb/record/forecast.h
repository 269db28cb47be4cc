// SPDX-License-Identifier: MIT
// Where will a body be, what will it hit, and how will it bounce?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb {

/// What comes to touch the body on its way.
struct ForecastHit {
    int tick = 0;              ///< after which it has happened, 1 or more
    Vec2 point{0, 0};          ///< in the world [m]
    Vec2 normal{0, 1};         ///< unit, away from what was hit [-]
    double approachSpeed = 0;  ///< along the normal [m/s]
    ShapeId other;             ///< what was hit
};

struct Forecast {
    std::vector<Transform> poses;   ///< of the body, local to world: now, and after each tick
    std::vector<Vec2> velocities;   ///< of its centre of mass, likewise [m/s]
    std::vector<ForecastHit> hits;  ///< in the order of ticks
};

/// What will become of a body in so many steps of dt [s], if nobody interferes: to the last bit what the world will do,
/// with all bounces, fields, joints and other bodies, for it is done in a copy of the world. The world stays as it is.
/// It takes as long as copying the world and stepping it; what sleeps takes no step's time.
/// A moving platform goes on as its velocity says. When the body leaves the range of numbers, so does its forecast: the
/// rest of the ticks it stays where its quarantine is.
/// Throws std::invalid_argument on a body that the world does not have, on negative ticks, and on a dt that
/// World::step would refuse. Test: "1,000 shots bounce as was forecast, to the last bit"
Forecast forecast(const World& world, BodyId body, int ticks, double dt);

/// The same for a body that would be added now: what a player is shown who aims.
Forecast forecast(const World& world, const BodyDef& shot, int ticks, double dt);

}  // namespace plumb
