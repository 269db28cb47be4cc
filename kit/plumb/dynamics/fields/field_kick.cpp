// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_kick.h>

#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

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

DragTerms meanDrag(const FieldPull& pull, double damping, const Vec2& acceleration, const Vec2& velocity, double time) {
    const DragTerms first = dragAt(pull, damping, acceleration, velocity);
    if (pull.quadratic.empty()) return first;
    return dragAt(pull, damping, acceleration, 0.5 * (velocity + after(first, velocity, time)));
}

/// The change of velocity by friction, given the velocity to that would result without it.
Vec2 frictionLoss(const Vec2& before, const Vec2& to, double most) {
    if (most <= 0) return {0, 0};
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
