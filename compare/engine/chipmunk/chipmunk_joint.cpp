// SPDX-License-Identifier: MIT
#include <compare/engine/chipmunk/chipmunk_joint.h>

#include <chipmunk/chipmunk_structs.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb::compare {
namespace {

constexpr double grooveEnd = 1e5;    // end of the groove of a slide without limits [m]
constexpr double springStart = 1e3;  // distance behind a slide, on its axis: its spring pulls and pushes from there [m]

class ChipmunkJoiner {
public:
    ChipmunkJoiner(const ChipmunkBuilt& built, const JointGeometry& joint, const std::string& name)
        : built_(built), joint_(joint), name_(name) {
        if (std::holds_alternative<GearJointDef>(joint.def)) return;
        if (std::holds_alternative<TargetJointDef>(joint.def)) return;
        hold(joint.bodyA, joint.bodyB);
    }

    /// Soft parts come before rigid ones, because the solver satisfies the last part best.
    ChipmunkJoint operator()(const RevoluteJointDef& def) {
        if (def.spring) turningSpring(*def.spring, def.restAngle);
        motor(def.motorSpeed, def.maxMotorTorque);
        if (def.limit) turn(cpRotaryLimitJointNew(a_, b_, apart() + def.limit->lower, apart() + def.limit->upper));
        pivot();
        return made();
    }

    ChipmunkJoint operator()(const PrismaticJointDef& def) {
        if (def.maxMotorForce > 0) refuse("no motor along a slide");
        if (def.spring) axialSpring(*def.spring, def.restShift);
        turn(cpGearJointNew(a_, b_, apart(), 1));
        groove(def.limit);
        return made();
    }

    ChipmunkJoint operator()(const DistanceJointDef& def) {
        if (def.maxMotorForce > 0) refuse("no motor between two points");
        if (!def.spring) {
            cpConstraint* rod = cpPinJointNew(a_, b_, anchorA(), anchorB());
            cpPinJointSetDist(rod, *joint_.length);
            move(rod);
            return made();
        }
        if (def.spring->stiffness > 0 || def.spring->damping > 0)
            move(cpDampedSpringNew(a_, b_, anchorA(), anchorB(), *joint_.length, def.spring->stiffness,
                                   def.spring->damping));
        if (def.minLength > 0 || def.maxLength < unlimited)
            move(cpSlideJointNew(a_, b_, anchorA(), anchorB(), def.minLength, def.maxLength));
        return made();
    }

    ChipmunkJoint operator()(const WeldJointDef& def) {
        if (def.spring) refuse("no weld whose anchor gives");
        if (def.bending)
            turningSpring(*def.bending, 0);
        else
            turn(cpGearJointNew(a_, b_, apart(), 1));
        pivot();
        return made();
    }

    ChipmunkJoint operator()(const WheelJointDef& def) {
        if (def.spring) axialSpring(*def.spring, def.restShift);
        motor(def.motorSpeed, def.maxMotorTorque);
        groove(def.limit);
        return made();
    }

    ChipmunkJoint operator()(const PulleyJointDef&) { refuse("no pulley"); }

    /// Chipmunk's gears couple two bodies, not two joints. This is the same if the bases never turn.
    ChipmunkJoint operator()(const GearJointDef& def) {
        const std::size_t first = drivenBy(joint_.jointA), second = drivenBy(joint_.jointB);
        if (first == second) refuse("no gear that drives one body by two joints");
        hold(first, second);
        const double phase = -def.ratio * bodyDef(second).angle - bodyDef(first).angle;
        turn(cpGearJointNew(a_, b_, phase, -def.ratio));
        collide_ = true;
        return made();
    }

    /// A pivot and a gear with limited force and torque. Their errors are removed at the joint's rate.
    ChipmunkJoint operator()(const MotorJointDef& def) {
        if (def.velocity != Vec2(0, 0) || def.angularVelocity != 0) refuse("no motor joint that moves at a velocity");
        const double dt = built_.scene.dt;
        const double errorLeft = std::pow(1 - std::min(def.rate * dt, 1.0), 1 / dt);  // share left after a second
        if (def.maxTorque > 0) {
            cpConstraint* gear = cpGearJointNew(a_, b_, def.angle.value_or(apart()), 1);
            cpConstraintSetMaxForce(gear, def.maxTorque);
            cpConstraintSetErrorBias(gear, errorLeft);
            turn(gear);
        }
        if (def.maxForce > 0) {
            const cpVect present = cpBodyWorldToLocal(a_, cpBodyGetPosition(b_));
            cpConstraint* pivot = cpPivotJointNew2(a_, b_, def.offset ? toChipmunk(*def.offset) : present, cpvzero);
            cpConstraintSetMaxForce(pivot, def.maxForce);
            cpConstraintSetErrorBias(pivot, errorLeft);
            move(pivot);
        }
        return made();
    }

    ChipmunkJoint operator()(const TargetJointDef&) {
        refuse("no spring that is damped across its line, as a target's");
    }

    /// A joint that allows any distance between two points. It only keeps the bodies from touching.
    ChipmunkJoint operator()(const FilterJointDef&) {
        move(cpSlideJointNew(a_, b_, cpvzero, cpvzero, 0, unlimited));
        collide_ = false;
        return made();
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Unsupported(fmt::format("joint {}: Chipmunk has {}", name_, what));
    }

    const BodyDef& bodyDef(std::size_t body) const { return built_.scene.bodies[body].def; }
    cpVect anchorA() const { return toChipmunk(joint_.localAnchorA); }
    cpVect anchorB() const { return toChipmunk(joint_.localAnchorB); }
    /// The joint's angle is counted from this one. Chipmunk counts angles from where neither body is turned.
    double apart() const { return bodyDef(joint_.bodyB).angle - bodyDef(joint_.bodyA).angle; }

    void hold(std::size_t bodyA, std::size_t bodyB) {
        const ChipmunkBody &first = *built_.bodies[bodyA], &second = *built_.bodies[bodyB];
        a_ = first.body.get();
        b_ = second.body.get();
        const auto any = [&](auto&& can) { return first.enabled && second.enabled && (can(a_) || can(b_)); };
        moves_ = any([](cpBody* body) { return cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC; });
        turns_ = any([](cpBody* body) { return std::isfinite(cpBodyGetMoment(body)); });
        collide_ = joint_.collideConnected;
    }

    /// If the bodies cannot follow a part, it would end the program or make infinite numbers: such a part is left out.
    void keep(cpConstraint* part, bool can) {
        OwnedChipmunk<cpConstraint> owned(part);
        if (can) result_.parts.push_back(std::move(owned));
    }
    void move(cpConstraint* part) { keep(part, moves_); }
    void turn(cpConstraint* part) { keep(part, turns_); }

    void pivot() { move(cpPivotJointNew2(a_, b_, anchorA(), anchorB())); }

    cpVect onAxis(double shift) const { return toChipmunk(joint_.localAnchorA + shift * joint_.localAxis); }

    /// The ends of the groove are the limits. If the limits are equal, a pivot is used instead.
    void groove(const std::optional<Limit>& limit) {
        const double lower = limit ? std::max(limit->lower, -grooveEnd) : -grooveEnd;
        const double upper = limit ? std::min(limit->upper, grooveEnd) : grooveEnd;
        if (upper - lower > 1e-9)
            move(cpGrooveJointNew(a_, b_, onAxis(lower), onAxis(upper), anchorB()));
        else
            move(cpPivotJointNew2(a_, b_, onAxis(lower), anchorB()));
    }

    /// The spring starts at a point far behind, so that it pulls and pushes along the axis.
    void axialSpring(const Spring& spring, double rest) {
        move(cpDampedSpringNew(a_, b_, onAxis(-springStart), anchorB(), springStart + rest, spring.stiffness,
                               spring.damping));
    }

    /// Chipmunk counts the spring's rest angle from B to A.
    void turningSpring(const Spring& spring, double rest) {
        turn(cpDampedRotarySpringNew(a_, b_, -(apart() + rest), spring.stiffness, spring.damping));
    }

    /// Chipmunk also counts the motor's rate as A's relative to B.
    void motor(double speed, double most) {
        if (most <= 0) return;
        cpConstraint* part = cpSimpleMotorNew(a_, b_, -speed);
        cpConstraintSetMaxForce(part, most);
        turn(part);
    }

    std::size_t drivenBy(std::size_t joint) const {
        const JointGeometry& hinge = built_.joints[joint];
        if (!std::holds_alternative<RevoluteJointDef>(hinge.def)) refuse("no gear with a slide");
        if (bodyDef(hinge.bodyA).type != BodyType::Static) refuse("no gear on a base that may turn");
        return hinge.bodyB;
    }

    ChipmunkJoint made() {
        for (const OwnedChipmunk<cpConstraint>& part : result_.parts) {
            cpConstraintSetCollideBodies(part.get(), static_cast<cpBool>(collide_));
            cpSpaceAddConstraint(&built_.space, part.get());
        }
        result_.there = true;
        return std::move(result_);
    }

    const ChipmunkBuilt& built_;
    const JointGeometry& joint_;
    const std::string& name_;
    cpBody *a_ = nullptr, *b_ = nullptr;
    bool moves_ = false, turns_ = false, collide_ = false;
    ChipmunkJoint result_;
};

/// The impulse that one part gave to B. It is read from the part's members, because the library's own function gives
/// its size, but not its direction.
ChipmunkImpulse impulseOfPart(const cpConstraint* part) {
    const auto along = [](const cpVect& n, double size) { return ChipmunkImpulse{size * fromChipmunk(n), 0}; };
    if (cpConstraintIsPivotJoint(part)) return {fromChipmunk(reinterpret_cast<const cpPivotJoint*>(part)->jAcc), 0};
    if (cpConstraintIsGrooveJoint(part)) return {fromChipmunk(reinterpret_cast<const cpGrooveJoint*>(part)->jAcc), 0};
    if (cpConstraintIsPinJoint(part)) {
        const auto* pin = reinterpret_cast<const cpPinJoint*>(part);
        return along(pin->n, pin->jnAcc);
    }
    if (cpConstraintIsSlideJoint(part)) {
        const auto* slide = reinterpret_cast<const cpSlideJoint*>(part);
        return along(slide->n, slide->jnAcc);
    }
    if (cpConstraintIsDampedSpring(part)) {
        const auto* spring = reinterpret_cast<const cpDampedSpring*>(part);
        return along(spring->n, spring->jAcc);
    }
    if (cpConstraintIsGearJoint(part)) return {{0, 0}, reinterpret_cast<const cpGearJoint*>(part)->jAcc};
    if (cpConstraintIsSimpleMotor(part)) return {{0, 0}, reinterpret_cast<const cpSimpleMotor*>(part)->jAcc};
    if (cpConstraintIsRotaryLimitJoint(part)) return {{0, 0}, reinterpret_cast<const cpRotaryLimitJoint*>(part)->jAcc};
    return {{0, 0}, reinterpret_cast<const cpDampedRotarySpring*>(part)->jAcc};
}

}  // namespace

ChipmunkJoint addChipmunkJoint(const ChipmunkBuilt& built, const JointGeometry& joint, const std::string& name) {
    return std::visit(ChipmunkJoiner(built, joint, name), joint.def);
}

void removeChipmunkJoint(cpSpace& space, ChipmunkJoint& joint) {
    for (const OwnedChipmunk<cpConstraint>& part : joint.parts) cpSpaceRemoveConstraint(&space, part.get());
    joint = {};
}

bool holdsInChipmunk(const ChipmunkJoint& joint, const cpBody* body) {
    return std::ranges::any_of(joint.parts, [body](const OwnedChipmunk<cpConstraint>& part) {
        return cpConstraintGetBodyA(part.get()) == body || cpConstraintGetBodyB(part.get()) == body;
    });
}

ChipmunkImpulse chipmunkImpulseOf(const ChipmunkJoint& joint) {
    ChipmunkImpulse sum;
    for (const OwnedChipmunk<cpConstraint>& part : joint.parts) {
        const ChipmunkImpulse its = impulseOfPart(part.get());
        sum.linear += its.linear;
        sum.angular += its.angular;
    }
    return sum;
}

}  // namespace plumb::compare
