// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_force.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/fields/field_energy.h>
#include <plumb/dynamics/fields/field_scope.h>
#include <plumb/dynamics/fields/submerged_parts.h>
#include <plumb/forces/gravity.h>

namespace plumb {

namespace {

/// Adds up the pulls of fields on one body.
class ForceSum {
public:
    ForceSum(const FieldStores& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull)
        : view_(view), body_(body), now_(now), record_(view.bodies.record[body]), pull_(pull) {}

    void add(const FieldRecord& field) {
        field_ = &field;
        there_ = now_[body_];
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

    /// The body that carries the magnet gets the reaction of its pull on the others.
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

}  // namespace plumb
