// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/free_motion.h>

#include <algorithm>
#include <cmath>

namespace plumb {

// The same as dragStep of kinematics, but fast for short steps: every damped body needs it in every step, so the series
// has no division by a variable, and no exponential.
Decay decay(double damping, double time) {
    const double x = damping * time;
    if (x < 1e-17) return {1, time, 0.5 * time * time};  // equal in double precision, and 1 / damping^2 may overflow
    // x - lost loses digits for small x (cancellation): below 0.05 by its series, relative error 1e-17 with nine terms
    double lost = 0, rest = 0;
    if (x < 0.05) {
        const double small = 1.0 / 720 - x * (1.0 / 5040 - x * (1.0 / 40320 - x * (1.0 / 362880 - x / 3628800)));
        rest = x * x * (0.5 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * small))));
        lost = x - rest;
    } else {
        lost = -exponentialMinus1(-x);
        rest = x - lost;
    }
    return {1 - lost, lost / damping, rest / (damping * damping)};
}

FlightLaw flightLawOf(const BodyStore& bodies, BodyIndex body) {
    const BodyRecord& record = bodies.record[body];
    if (record.type != BodyType::Dynamic) return {};
    if (const std::uint32_t flight = bodies.step[body].flight; flight != none) return bodies.flights[flight].law;
    return {accelerationOf(record, bodies.gravity), record.linearDamping, record.angularDamping};
}

BodyMotion moveFreely(const BodyMotion& from, const FlightLaw& law, double time) {
    const Decay linear = decay(law.linearDamping, time);
    const Decay angular = decay(law.angularDamping, time);
    const Acceleration& a = law.acceleration;
    BodyMotion to = from;
    to.center += from.velocity * linear.gain + a.linear * linear.reach;
    to.velocity = from.velocity * linear.keep + a.linear * linear.gain;
    to.angle += from.angularVelocity * angular.gain + a.angular * angular.reach;
    to.angularVelocity = from.angularVelocity * angular.keep + a.angular * angular.gain;
    if (to.angle != from.angle) to.rotation = Rot::fromAngle(to.angle);
    return to;
}

double restingSpeed(const BodyStore& bodies, BodyIndex a, BodyIndex b, const Vec2& normal) {
    const auto pullOn = [&](BodyIndex body) {
        const Vec2 pull = flightLawOf(bodies, body).acceleration.linear;
        return bodies.links[body].actingJoints > 0 ? pull.norm() : std::fabs(pull.dot(normal));
    };
    return 0.5 * bodies.lastStep * std::max(pullOn(a), pullOn(b));
}

/// After the solver, O(awake bodies): what neither the impacts nor the solver have moved goes the whole step at once.
/// So a body that meets nothing is exact at any dt. Where varying fields act, the law leads to the right place, and
/// rest corrects the velocity.
void moveFreeBodies(BodyStore& bodies, double dt, StepObserver* observer) {
    for (const BodyIndex body : bodies.awake) {
        if (!bodies.isMovedBy(body, MovedBy::ClosedForm)) continue;
        const BodyMotion from = bodies.motion[body];
        storeMotion(bodies, body, moveFreely(from, flightLawOf(bodies, body), dt));
        if (observer != nullptr) observer->noteFlight(body, from, bodies.motion[body], dt);
        const std::uint32_t flight = bodies.step[body].flight;
        if (flight == none || bodies.flights[flight].steady) continue;
        BodyMotion motion = bodies.motion[body];
        motion.velocity += bodies.flights[flight].rest.velocity;
        motion.angularVelocity += bodies.flights[flight].rest.spin;
        storeMotion(bodies, body, motion);
        if (observer != nullptr) observer->noteFieldFlight(flight);
    }
}

Sweep sweepBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record) {
    return {from.center, to.center - from.center, from.angle, to.angle - from.angle, record.localCenter};
}

Sweep wallSweepOf(const BodyStore& bodies, BodyIndex wall, const StepPart& part) {
    const BodyRecord& record = bodies.record[wall];
    const BodyMotion& start = bodies.motion[wall];
    if (!record.awake) return sweepBetween(start, start, record);
    const FlightLaw law = flightLawOf(bodies, wall);
    return sweepBetween(moveFreely(start, law, part.from), moveFreely(start, law, part.to), record);
}

double travelOf(const Vec2& shift, double turn, const BodyRecord& record) {
    return shift.norm() + std::fabs(turn) * record.turningRadius;
}

}  // namespace plumb
