// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/load_bodies.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/quarantine.h>

namespace plumb {

namespace {

SolverVelocity rowOf(const Vec2& linear, double angular, float inverseRho, float last) {
    return {static_cast<float>(linear.x()), static_cast<float>(linear.y()), static_cast<float>(angular) * inverseRho,
            last};
}

}  // namespace

bool loadBody(WorldState& world, BodyIndex body, double dt) {
    BodyStore& bodies = world.bodies;
    BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const FlightLaw law = flightLawOf(world, body);
    const Acceleration& a = law.acceleration;
    record.constrained = record.flown = false;
    bodies.pushed[body] = 0;
    if (!isSound(motion) || !isSound(a)) {
        quarantineLater(world, body);
        bodies.rest(body);
        return false;
    }
    BodyPlace place = placeOf(motion, record.rho);
    const Vec2 shift = motion.velocity * dt + a.linear * (0.5 * dt * dt);
    const double angle = (std::fabs(motion.angularVelocity) + std::fabs(a.angular) * dt) * dt;
    place.shiftX = static_cast<float>(shift.x());
    place.shiftY = static_cast<float>(shift.y());
    place.turn = static_cast<float>(record.reach * std::min(angle, 2.0));
    place.pullX = static_cast<float>(a.linear.x() * (0.5 * dt));
    place.pullY = static_cast<float>(a.linear.y() * (0.5 * dt));
    bodies.place[body] = place;

    const float inverseMass = static_cast<float>(record.inverseMass);
    bodies.velocity[body] = rowOf(motion.velocity, motion.angularVelocity, record.inverseRho, inverseMass);
    bodies.displacement[body] = {};
    bodies.warm[body] = {};
    bodies.turn[body] = {0, record.rho, record.inverseRho, 0};
    if (record.flight != none) {  // the fields do it all, gravity and damping included
        bodies.kick[body] = {};
        return true;
    }
    const double half = 0.5 * dt / world.def.solver.subSteps;
    const Decay linear = decay(law.linearDamping, half);
    const Decay angular = decay(law.angularDamping, half);
    bodies.kick[body].gain = rowOf(a.linear * linear.gain, a.angular * angular.gain, record.inverseRho, 0);
    bodies.kick[body].keep = {static_cast<float>(linear.keep), static_cast<float>(linear.keep),
                              static_cast<float>(angular.keep), 1};
    return true;
}

void loadBodies(WorldState& world, double dt) {
    world.strays.forget();
    for (const BodyIndex body : world.bodies.awake) {
        if (!loadBody(world, body, dt)) continue;
        placeBody(world, body, dt);
        world.bodies.record[body].boxesWait = false;
    }
}

}  // namespace plumb
