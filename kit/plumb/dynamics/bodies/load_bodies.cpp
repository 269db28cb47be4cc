// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/load_bodies.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

namespace {

SolverVelocity rowOf(const Vec2& linear, double angular, float gyration, float last) {
    return {static_cast<float>(linear.x()), static_cast<float>(linear.y()), static_cast<float>(angular) * gyration,
            last};
}

}  // namespace

float farSpeedSquared(const BodyRecord& body, double dt) {
    if (body.type != BodyType::Dynamic) return std::numeric_limits<float>::infinity();
    const double reach = std::max(1.0, body.turningRadius * static_cast<double>(body.inverseGyration));
    const double speed = farShare * body.inradius / (dt * reach);
    return static_cast<float>(std::min(0.5 * speed * speed, 1e30));
}

void loadBody(BodyStore& bodies, BodyIndex body, double dt) {
    const BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const FlightLaw law = flightLawOf(bodies, body);
    const Acceleration& a = law.acceleration;
    if (!isInRange(motion) || !isInRange(a)) {
        markOutOfRange(bodies, body);
        bodies.rest(body);
        return;
    }
    bodies.step[body].movedBy = MovedBy::ClosedForm;
    BodyPlace place = placeOf(motion, record.inverseGyration);
    const Vec2 shift = motion.velocity * dt + a.linear * (0.5 * dt * dt);
    const double angle = (std::fabs(motion.angularVelocity) + std::fabs(a.angular) * dt) * dt;
    place.shiftX = static_cast<float>(shift.x());
    place.shiftY = static_cast<float>(shift.y());
    // A chord is at most two radii long, however far the body turns.
    place.turn = static_cast<float>(record.turningRadius * std::min(angle, 2.0));
    place.pullX = static_cast<float>(a.linear.x() * (0.5 * dt));
    place.pullY = static_cast<float>(a.linear.y() * (0.5 * dt));
    bodies.place[body] = place;

    const float inverseMass = static_cast<float>(record.inverseMass);
    bodies.velocity[body] = rowOf(motion.velocity, motion.angularVelocity, record.gyration, inverseMass);
    bodies.displacement[body] = {};
    bodies.warm[body] = {};
    bodies.turn[body] = {0, record.inverseGyration, record.gyration, farSpeedSquared(record, dt)};
    if (bodies.step[body].flight != none) {  // the fields' kicks include gravity and damping
        bodies.kick[body] = {};
        return;
    }
    // By the closed form of damped motion, so that any damping is stable, and exact for a body without contacts.
    const double half = 0.5 * dt / bodies.subSteps;
    const Decay linear = decay(law.linearDamping, half);
    const Decay angular = decay(law.angularDamping, half);
    bodies.kick[body].gain = rowOf(a.linear * linear.gain, a.angular * angular.gain, record.gyration, 0);
    bodies.kick[body].keep = {static_cast<float>(linear.keep), static_cast<float>(linear.keep),
                              static_cast<float>(angular.keep), 1};
}

}  // namespace plumb
