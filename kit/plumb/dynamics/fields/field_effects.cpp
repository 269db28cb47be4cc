// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_effects.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/fields/field_scope.h>
#include <plumb/dynamics/fields/placed_outline.h>
#include <plumb/forces/gravity.h>

namespace plumb {

namespace {

/// Adds up the pulls of fields on one body: forces, which do not depend on the velocity, go to acceleration; drag goes
/// to rates, which kickOf turns into an exponential. As a force, a great drag would reverse the velocity within a step.
/// Test: "a parachute that stops in a millisecond does not touch a wall it never reaches"
class ForceSum {
public:
    ForceSum(const FieldStores& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull)
        : view_(view), body_(body), now_(now), record_(view.bodies.record[body]), pull_(pull) {}

    void add(const FieldRecord& field) {
        field_ = &field;
        there_ = now_[body_];
        // Its carrier may be outside of the region and of the filter, and still gets the reaction.
        if (const auto* magnet = std::get_if<Magnet>(&field.def.law)) {
            if (isCarried(*magnet, view_)) pull(*magnet);
            return;
        }
        if (!actsOn(field, view_, body_, motion())) return;
        there_.center += *shiftInto(field, view_, there_.center);
        std::visit([this](const auto& law) { pull(law); }, field.def.law);
    }

private:
    /// The body's motion, shifted to where the field acts (see shiftInto).
    const BodyMotion& motion() const { return there_; }

    /// Is a body that passes the field's filter also in its region?
    bool isWithin(BodyIndex other) const {
        return isInRange(now_[other]) && shiftInto(*field_, view_, now_[other].center).has_value();
    }
    Vec2 nearTo(const Vec2& place, const Vec2& other) const { return view_.bodies.near(place, other); }

    void push(const Vec2& force, const Vec2& at) {
        Acceleration a{force * record_.inverseMass, cross(Vec2(at - motion().center), force) * record_.inverseInertia};
        pull_.acceleration.linear += a.linear;
        pull_.acceleration.angular += a.angular;
        // What has a potential energy is accounted for by it; the rest by its work, kick by kick.
        if (hasEnergy(field_->def)) return;
        pull_.unaccounted.linear += a.linear;
        pull_.unaccounted.angular += a.angular;
    }
    void pushCenter(const Vec2& force) { push(force, motion().center); }

    void pull(const UniformGravity& law) { pushCenter(gravityForce(law, record_.mass)); }

    void pull(const MutualGravity& law) {
        const PointMass self{record_.mass, motion().center};
        Vec2 sum(0, 0);
        for (const BodyIndex other : field_->attracted)
            if (other != body_ && isWithin(other))
                sum += gravityForceOf(law, {view_.bodies.record[other].mass, nearTo(now_[other].center, self.position)},
                                      self);
        pushCenter(sum);
    }

    void pull(const Attractor& law) { pushCenter(attraction(law, motion().center)); }

    /// The body that carries the magnet gets the reaction of its pull on the others, at the place of the magnet, so
    /// that momentum is kept. Test: "a magnet on a body is drawn as it draws"
    void pull(const Magnet& law) {
        Attractor attractor = attractorOf(law, view_, now_);
        attractor.center = nearTo(attractor.center, motion().center);
        if (law.body.index != body_) {
            if (actsOn(*field_, view_, body_, motion())) pull(attractor);
            return;
        }
        if (!view_.bodies.canMove(body_)) return;
        for (const BodyIndex other : field_->attracted)
            if (other != body_ && isWithin(other))
                push(-attraction(attractor, nearTo(now_[other].center, attractor.center)), attractor.center);
    }

    void pull(const Pool& law) {
        for (const Submerged& part : submergedPartsOf(view_.bodies, view_.space, body_, motion(), law.fluid)) {
            push(buoyancyForce(law.fluid, part), part.centroid);
            slow(law.drag * part.area * record_.inverseMass, law.flow);
            pull_.turning += law.drag * part.area * record_.inverseMass;
        }
    }

    void pull(const Drag& law) {
        slow(law.linear * record_.inverseMass, law.wind);
        if (law.quadratic > 0) pull_.quadratic.push_back({law.quadratic * record_.inverseMass, law.wind});
    }

    void slow(double rate, const Vec2& flow) {
        pull_.linear += rate;
        pull_.flow += rate * flow;
    }

    void pull(const GroundFriction& law) {
        // A disc that spins on the ground under even pressure is braked by mu m g 2/3 R; R = sqrt(2 I / m) is the disc
        // of the body's inertia. mu friction [-], R [m], I [kg m^2]
        const double lever = law.lever > 0 ? law.lever : 2.0 / 3 * std::sqrt(2 * record_.inertia * record_.inverseMass);
        pull_.friction += law.friction * law.gravity;
        pull_.spinFriction += law.friction * law.gravity * lever * record_.mass * record_.inverseInertia;
    }

    const FieldStores& view_;
    BodyIndex body_;
    const std::vector<BodyMotion>& now_;
    const BodyRecord& record_;
    FieldPull& pull_;
    const FieldRecord* field_ = nullptr;
    BodyMotion there_;
};

}  // namespace

void pullOn(const FieldStores& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull) {
    std::vector<SpeedDrag> quadratic = std::move(pull.quadratic);  // to reuse its memory
    quadratic.clear();
    pull = {};
    pull.quadratic = std::move(quadratic);
    ForceSum sum(view, body, now, pull);
    for (const FieldRecord& field : view.fields.records)
        if (field.alive) sum.add(field);
}

namespace {

/// Two bodies at the same place, or too near for a finite number, have no force on each other, and so no energy.
double finite(double energy) {
    return std::isfinite(energy) ? energy : 0;
}

/// Each pair once: O(n^2). Only the ledger asks.
double mutualEnergy(const FieldStores& view, const FieldRecord& field, const MutualGravity& law) {
    double sum = 0;
    const std::vector<BodyMotion>& now = view.bodies.motion;
    const auto massOf = [&](BodyIndex body) { return PointMass{view.bodies.record[body].mass, now[body].center}; };
    for (BodyIndex a = 1; a < now.size(); ++a) {
        if (!actsOn(field, view, a, now[a])) continue;
        for (BodyIndex b = a + 1; b < now.size(); ++b)
            if (actsOn(field, view, b, now[b])) {
                PointMass other = massOf(b);
                other.position = view.bodies.near(other.position, now[a].center);
                sum += finite(potentialEnergy(law, massOf(a), other));
            }
    }
    return sum;
}

double mutualEnergy(const FieldStores& view, const FieldRecord& field, const MutualGravity& law, BodyIndex body,
                    const BodyMotion& there) {
    double sum = 0;
    const std::vector<BodyMotion>& now = view.bodies.motion;
    const PointMass self{view.bodies.record[body].mass, there.center};
    for (BodyIndex other = 1; other < now.size(); ++other)
        if (other != body && actsOn(field, view, other, now[other]))
            sum += finite(potentialEnergy(
                law, {view.bodies.record[other].mass, view.bodies.near(now[other].center, there.center)}, self));
    return sum;
}

/// The energy of one body in a field that acts on each body independently of the others.
double energyIn(const FieldStores& view, const FieldRecord& field, BodyIndex body, BodyMotion motion) {
    const FieldLaw& law = field.def.law;
    motion.center += shiftInto(field, view, motion.center).value_or(Vec2(0, 0));
    if (const auto* uniform = std::get_if<UniformGravity>(&law))
        return potentialEnergy(*uniform, view.bodies.record[body].mass, motion.center);
    if (const auto* attractor = std::get_if<Attractor>(&law)) return finite(potentialEnergy(*attractor, motion.center));
    if (const auto* magnet = std::get_if<Magnet>(&law)) {
        Attractor attractor = attractorOf(*magnet, view, view.bodies.motion);
        attractor.center = view.bodies.near(attractor.center, motion.center);
        return finite(potentialEnergy(attractor, motion.center));
    }
    double sum = 0;
    if (const auto* pool = std::get_if<Pool>(&law))
        for (const Submerged& part : submergedPartsOf(view.bodies, view.space, body, motion, pool->fluid))
            sum += potentialEnergy(pool->fluid, part);
    return sum;
}

}  // namespace

/// A region has none: on its edge the force begins at once, and a closed path across it would gain energy.
bool hasEnergy(const FieldDef& field) {
    return !field.region && !std::holds_alternative<Drag>(field.law) &&
           !std::holds_alternative<GroundFriction>(field.law);
}

double fieldEnergyOf(const FieldStores& view) {
    double sum = 0;
    for (const FieldRecord& field : view.fields.records) {
        if (!field.alive || !hasEnergy(field.def)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(view, field, *mutual);
        else
            for (const BodyIndex body : bodiesInfluencedBy(view, field))
                sum += energyIn(view, field, body, view.bodies.motion[body]);
    }
    return sum;
}

double fieldEnergyOf(const FieldStores& view, BodyIndex body, const BodyMotion& there) {
    double sum = 0;
    for (const FieldRecord& field : view.fields.records) {
        if (!field.alive || !hasEnergy(field.def) || !actsOn(field, view, body, there)) continue;
        if (const auto* mutual = std::get_if<MutualGravity>(&field.def.law))
            sum += mutualEnergy(view, field, *mutual, body, there);
        else if (!isCarriedBy(field.def.law, body))
            sum += energyIn(view, field, body, there);
    }
    return sum;
}

namespace {

/// Drag rate [1/s] and driving acceleration [m/s^2] at a velocity.
struct DragTerms {
    double rate = 0;
    Vec2 drive{0, 0};
};

DragTerms dragAt(const FieldPull& pull, double damping, const Vec2& acceleration, const Vec2& velocity) {
    DragTerms s{damping + pull.linear, acceleration + pull.flow};
    for (const SpeedDrag& drag : pull.quadratic) {
        const double rate = drag.rate * (velocity - drag.flow).norm();
        s.rate += rate;
        s.drive += rate * drag.flow;
    }
    return s;
}

Vec2 after(const DragTerms& drag, const Vec2& velocity, double time) {
    const Decay d = decay(drag.rate, time);
    return velocity * d.keep + drag.drive * d.gain;
}

/// Quadratic drag at the mean of the velocity and of a first guess of the next one: a midpoint rule, of second order.
/// Linear drag is the same at any velocity, and needs no guess.
DragTerms meanDrag(const FieldPull& pull, double damping, const Vec2& acceleration, const Vec2& velocity, double time) {
    const DragTerms first = dragAt(pull, damping, acceleration, velocity);
    if (pull.quadratic.empty()) return first;
    return dragAt(pull, damping, acceleration, 0.5 * (velocity + after(first, velocity, time)));
}

/// The change of velocity by friction, given the velocity to that would result without it.
Vec2 frictionLoss(const Vec2& before, const Vec2& to, double most) {
    if (most <= 0) return {0, 0};
    // It is stopped, and not driven back.
    if (to.norm() <= most) return -to;
    // The rest of the kick may turn round the velocity of bodies that contacts press together: then no mean direction
    // exists.
    const Vec2 way = before.dot(to) > 0 ? Vec2(before + to) : to;
    const Vec2 off = -way * (most / way.norm());
    return to.dot(Vec2(to + off)) > 0 ? off : Vec2(-to);
}

double frictionLoss(double to, double most) {
    if (most <= 0) return 0;
    return std::fabs(to) <= most ? -to : (to > 0 ? -most : most);
}

}  // namespace

/// The parts of the change are kept apart, because the ledger enters each under its own cause: their sum is what is
/// applied. First all forces with drag, then friction, which acts on what is left: so a body at rest is moved only by
/// more than friction holds.
FieldKick kickOf(const BodyRecord& body, const Acceleration& base, const FieldPull& pull,
                 const VelocityChange& velocity, double time) {
    FieldKick kick;
    kick.forced = {pull.unaccounted.linear * time, pull.unaccounted.angular * time};
    kick.kept.velocity = (base.linear + pull.acceleration.linear) * time - kick.forced.velocity;
    kick.kept.spin = (base.angular + pull.acceleration.angular) * time - kick.forced.spin;

    const Vec2 acceleration = base.linear + pull.acceleration.linear;
    const DragTerms drag = meanDrag(pull, body.linearDamping, acceleration, velocity.velocity, time);
    const Vec2 to = after(drag, velocity.velocity, time);
    // Without drag the difference is rounding.
    if (drag.rate > 0) kick.damped.velocity = to - velocity.velocity - acceleration * time;
    kick.friction.velocity = frictionLoss(velocity.velocity, to, pull.friction * time);

    kick.rate = drag.rate;
    kick.turningRate = body.angularDamping + pull.turning;
    const Decay turning = decay(kick.turningRate, time);
    const double angular = base.angular + pull.acceleration.angular;
    const double spin = velocity.spin * turning.keep + angular * turning.gain;
    if (kick.turningRate > 0) kick.damped.spin = spin - velocity.spin - angular * time;
    kick.friction.spin = frictionLoss(spin, pull.spinFriction * time);
    return kick;
}

}  // namespace plumb
