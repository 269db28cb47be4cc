// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/body_motion.h>

#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

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
