// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/field_solving.h>

#include <plumb/dynamics/detail/field_kick.h>
#include <plumb/dynamics/detail/free_motion.h>

namespace plumb {

namespace {

BodyMotion solvedMotion(const BodyStore& bodies, BodyIndex body) {
    BodyMotion motion = bodies.motion[body];
    const SolverDisplacement& d = bodies.displacement[body];
    motion.center += Vec2(static_cast<double>(d.x), static_cast<double>(d.y));
    motion.angle += static_cast<double>(bodies.turn[body].angle);
    motion.rotation = Rot::fromAngle(motion.angle);
    return motion;
}

Push speedsOf(const BodyStore& bodies, BodyIndex body) {
    const SolverVelocity& v = bodies.velocity[body];
    return {{static_cast<double>(v.x), static_cast<double>(v.y)}, static_cast<double>(v.w * bodies.turn[body].rho)};
}

void addPush(SolverVelocity& velocity, const Push& push, float inverseRho) {
    velocity.x += static_cast<float>(push.velocity.x());
    velocity.y += static_cast<float>(push.velocity.y());
    velocity.w += static_cast<float>(push.spin) * inverseRho;
}

}  // namespace

void FieldSolving::look(const std::vector<BodyIndex>& solved) {
    std::vector<BodyMotion>& now = world_.fields.now;
    if (looksAround(world_)) {
        // What is not solved flies as it was foretold; what the impacts have flown is at the step's end already.
        now = world_.bodies.motion;
        for (const BodyIndex body : world_.bodies.awake) {
            const BodyRecord& record = world_.bodies.record[body];
            if (!record.constrained && !record.flown && subSteps_ > 0)
                now[body] = fly(now[body], flightLawOf(world_, body), subSteps_ * h_);
        }
        for (const BodyIndex body : solved)
            if (body != noBody) now[body] = solvedMotion(world_.bodies, body);
    }
    pulls_.resize(solved.size());
    for (std::size_t i = 0; i < solved.size(); ++i) {
        if (!feels(solved[i])) continue;
        now[solved[i]] = solvedMotion(world_.bodies, solved[i]);
        pullOn(world_, solved[i], now, pulls_[i]);
    }
    looked_ = true;
    ++subSteps_;
}

bool FieldSolving::feels(BodyIndex body) const {
    return body != noBody && world_.bodies.record[body].flight != none;
}

void FieldSolving::kick(const std::vector<BodyIndex>& solved) {
    if (world_.fields.flights.empty()) return;
    if (!looked_) look(solved);
    BodyStore& bodies = world_.bodies;
    for (std::size_t i = 0; i < solved.size(); ++i) {
        const BodyIndex body = solved[i];
        if (!feels(body)) continue;
        const BodyRecord& record = bodies.record[body];
        const Acceleration base = accelerationOf(record, world_.def.gravity);
        const FieldKick kick = kickOf(record, base, pulls_[i], speedsOf(bodies, body), 0.5 * h_);
        const Push sum = sumOf(kick);
        addPush(bodies.velocity[body], sum, bodies.turn[body].inverseRho);
        addPush(bodies.before[body], sum, bodies.turn[body].inverseRho);
        if (world_.audit) world_.audit->noteFieldKick(world_, body, kick, base.linear * (0.5 * h_));
    }
}

}  // namespace plumb
