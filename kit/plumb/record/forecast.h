// SPDX-License-Identifier: MIT
// Where will a body be, what will it hit, and how will it bounce?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb {

/// A contact of the body that begins.
struct ForecastHit {
    int tick = 0;              ///< the tick after which it has begun, 1 or more
    Vec2 point{0, 0};          ///< in the world [m]
    Vec2 normal{0, 1};         ///< unit, away from the other shape [-]
    double approachSpeed = 0;  ///< along the normal [m/s]
    ShapeId other;             ///< the other shape
};

struct Forecast {
    std::vector<Transform> poses;   ///< of the body, local to world: now, and after each tick
    std::vector<Vec2> velocities;   ///< of its centre of mass, likewise [m/s]
    std::vector<ForecastHit> hits;  ///< in the order of ticks
};

/// The motion of a body in so many steps of dt [s], if nothing is changed meanwhile: exactly what the world will do, to
/// the last bit, with all bounces, fields, joints and other bodies, because it is computed in a copy of the world. The
/// world itself does not change. It takes as long as copying and stepping the world; sleeping bodies cost nothing in a
/// step. A moving platform continues with its velocity. If the body's numbers overflow, it stays where its quarantine
/// puts it for the rest of the forecast.
/// Throws std::invalid_argument on a body that is not in the world, on negative ticks, and on a dt that World::step
/// would refuse. Test: "1,000 shots bounce as was forecast, to the last bit"
Forecast forecast(const World& world, BodyId body, int ticks, double dt);

/// The same for a body that would be added now: for example, to show a player where a shot will go.
Forecast forecast(const World& world, const BodyDef& shot, int ticks, double dt);

}  // namespace plumb
