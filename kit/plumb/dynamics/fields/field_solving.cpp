// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_solving.h>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/bodies/solver_velocity.h>

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

}  // namespace

void FieldSolving::begin(FieldStore& fields, BodyStore& bodies, const Space& space, double h, StepObserver* observer) {
    fields_ = &fields;
    bodies_ = &bodies;
    space_ = &space;
    h_ = h;
    observer_ = observer;
    subSteps_ = 0;
    known_ = false;
}

/// Once a sub-step: the kick at its end and the one at the next one's start are at the same places.
void FieldSolving::findPulls(std::span<const BodyIndex> solved) {
    std::vector<BodyMotion>& now = fields_->now;
    if (dependsOnOtherBodies(*fields_)) {
        // Bodies that are not solved move as predicted; bodies that the impacts have moved are already at the step's
        // end.
        now = bodies_->motion;
        for (const BodyIndex body : bodies_->awake)
            if (!bodies_->isConstrained(body) && !bodies_->isMovedBy(body, MovedBy::Impacts) && subSteps_ > 0)
                now[body] = moveFreely(now[body], flightLawOf(*bodies_, body), subSteps_ * h_);
        for (const BodyIndex body : solved)
            if (body != noBody) now[body] = solvedMotion(*bodies_, body);
    }
    pulls_.resize(solved.size());
    for (std::size_t i = 0; i < solved.size(); ++i) {
        if (!isInfluenced(solved[i])) continue;
        now[solved[i]] = solvedMotion(*bodies_, solved[i]);
        pullOn({*fields_, *bodies_, *space_}, solved[i], now, pulls_[i]);
    }
    known_ = true;
    ++subSteps_;
}

bool FieldSolving::isInfluenced(BodyIndex body) const {
    return body != noBody && bodies_->step[body].flight != none;
}

/// The same kick as in free flight (kickOf), of which the contacts then take away what they stop.
void FieldSolving::kick(std::span<const BodyIndex> solved) {
    if (bodies_->flights.empty()) return;
    if (!known_) findPulls(solved);
    for (std::size_t i = 0; i < solved.size(); ++i) {
        const BodyIndex body = solved[i];
        if (!isInfluenced(body)) continue;
        const BodyRecord& record = bodies_->record[body];
        const Acceleration base = accelerationOf(record, bodies_->gravity);
        const Vec3 v = velocityOf(*bodies_, body);
        const FieldKick kick = kickOf(record, base, pulls_[i], {{v[0], v[1]}, v[2]}, 0.5 * h_);
        const VelocityChange sum = sumOf(kick);
        addVelocity(*bodies_, body, {sum.velocity.x(), sum.velocity.y(), sum.spin});
        if (observer_ != nullptr) observer_->noteFieldKick(body, kick, base.linear * (0.5 * h_));
    }
}

}  // namespace plumb
