// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_solving.h>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/fields/field_effects.h>
#include <plumb/dynamics/fields/field_scope.h>

namespace plumb {

namespace {

/// Where the solver has a body now: its place at the step's start is in double, the way since then in floats.
BodyMotion solvedMotion(const BodyStore& bodies, BodyIndex body) {
    BodyMotion motion = bodies.motion[body];
    const SolverDisplacement& d = bodies.displacement[body];
    motion.center += Vec2(static_cast<double>(d.x), static_cast<double>(d.y));
    motion.angle += static_cast<double>(bodies.turn[body].angle);
    motion.rotation = Rot::fromAngle(motion.angle);
    return motion;
}

VelocityChange speedsOf(const BodyStore& bodies, BodyIndex body) {
    const SolverVelocity& v = bodies.velocity[body];
    return {{static_cast<double>(v.x), static_cast<double>(v.y)},
            static_cast<double>(v.w * bodies.turn[body].inverseGyration)};
}

void addChange(SolverVelocity& velocity, const VelocityChange& push, float gyration) {
    velocity.x += static_cast<float>(push.velocity.x());
    velocity.y += static_cast<float>(push.velocity.y());
    velocity.w += static_cast<float>(push.spin) * gyration;
}

}  // namespace

/// Once a sub-step: the kick at its end and the one at the next one's start are at the same places.
void FieldSolving::findPulls(const std::vector<BodyIndex>& solved) {
    std::vector<BodyMotion>& now = fields_.now;
    if (dependsOnOtherBodies(fields_)) {
        // Bodies that are not solved move as predicted; bodies that the impacts have moved are already at the step's
        // end.
        now = bodies_.motion;
        for (const BodyIndex body : bodies_.awake)
            if (!bodies_.isConstrained(body) && !bodies_.isMovedBy(body, MovedBy::Impacts) && subSteps_ > 0)
                now[body] = moveFreely(now[body], flightLawOf(bodies_, body), subSteps_ * h_);
        for (const BodyIndex body : solved)
            if (body != noBody) now[body] = solvedMotion(bodies_, body);
    }
    pulls_.resize(solved.size());
    for (std::size_t i = 0; i < solved.size(); ++i) {
        if (!isInfluenced(solved[i])) continue;
        now[solved[i]] = solvedMotion(bodies_, solved[i]);
        pullOn({fields_, bodies_, space_}, solved[i], now, pulls_[i]);
    }
    known_ = true;
    ++subSteps_;
}

bool FieldSolving::isInfluenced(BodyIndex body) const {
    return body != noBody && bodies_.step[body].flight != none;
}

/// The same kick as in free flight (kickOf), of which the contacts then take away what they stop. It is added to
/// before, too: it must not count as a change by contacts, which are applied again (solver_body.h).
void FieldSolving::kick(const std::vector<BodyIndex>& solved) {
    if (!known_) findPulls(solved);
    for (std::size_t i = 0; i < solved.size(); ++i) {
        const BodyIndex body = solved[i];
        if (!isInfluenced(body)) continue;
        const BodyRecord& record = bodies_.record[body];
        const Acceleration base = accelerationOf(record, bodies_.gravity);
        const FieldKick kick = kickOf(record, base, pulls_[i], speedsOf(bodies_, body), 0.5 * h_);
        const VelocityChange sum = sumOf(kick);
        addChange(bodies_.velocity[body], sum, bodies_.turn[body].gyration);
        addChange(bodies_.before[body], sum, bodies_.turn[body].gyration);
        if (observer_ != nullptr) observer_->noteFieldKick(body, kick, base.linear * (0.5 * h_));
    }
}

}  // namespace plumb
