// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/body_motion.h>

#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

namespace {

/// A body that moves in a step by less than this share of its inradius cannot have passed its contacts [-].
constexpr double slow = 0.5;

/// By how much the solver has moved a body.
struct Moved {
    Vec2 shift{0, 0};
    double turn = 0;
};

Moved movedBy(const BodyStore& bodies, BodyIndex body) {
    const SolverDisplacement& moved = bodies.displacement[body];
    return {Vec2(static_cast<double>(moved.x), static_cast<double>(moved.y)),
            static_cast<double>(bodies.turn[body].angle)};
}

}  // namespace

Sweep sweepBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record) {
    return {from.center, to.center - from.center, from.angle, to.angle - from.angle, record.localCenter};
}

Sweep freeSweep(const BodyStore& bodies, BodyIndex body, const Past& past) {
    const BodyRecord& record = bodies.record[body];
    BodyMotion now = bodies.motion[body];
    if (!record.awake) return sweepBetween(now, now, record);
    const FlightLaw law = flightLawOf(bodies, body);
    if (const std::uint32_t flight = bodies.step[body].flight; flight != none) {  // without the correction at its end
        now.velocity -= bodies.flights[flight].rest.velocity;
        now.angularVelocity -= bodies.flights[flight].rest.spin;
    }
    return sweepBetween(moveFreely(now, law, -past.from), past.to > 0 ? moveFreely(now, law, -past.to) : now, record);
}

Sweep sweepOf(const BodyStore& bodies, BodyIndex body, double dt) {
    if (!bodies.isMovedBy(body, MovedBy::Solver)) return freeSweep(bodies, body, {dt, 0});
    const BodyMotion& now = bodies.motion[body];
    const Moved moved = movedBy(bodies, body);
    return {now.center - moved.shift, moved.shift, now.angle - moved.turn, moved.turn, bodies.record[body].localCenter};
}

double travelOf(const Vec2& shift, double turn, const BodyRecord& record) {
    return shift.norm() + std::fabs(turn) * record.turningRadius;
}

bool isFar(const BodyRecord& record, double travel) {
    return travel > slow * record.inradius;
}

bool hasMovedFar(const BodyStore& bodies, BodyIndex body, double dt) {
    const BodyRecord& record = bodies.record[body];
    if (bodies.isMovedBy(body, MovedBy::Solver)) {
        const Moved moved = movedBy(bodies, body);
        return isFar(record, travelOf(moved.shift, moved.turn, record));
    }
    const Sweep way = freeSweep(bodies, body, {dt, 0});
    return isFar(record, travelOf(way.shift, way.turn, record));
}

}  // namespace plumb
