// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>

namespace plumb::compare {
namespace {

constexpr double alike = 1e-9;  // lengths, masses and angles that differ by less are the same

const SwingsMotion* swingOf(const Scene& scene, const std::string& body) {
    for (const BodyMotion& motion : scene.closedForm->bodies)
        if (const auto* swings = std::get_if<SwingsMotion>(&motion); swings && swings->body == body) return swings;
    return nullptr;
}

bool differ(double a, double b) {
    return std::abs(a - b) > alike * std::max(1.0, std::abs(b));
}

/// The joint by which a disc of a row hangs: the joint of its motion, or else the first joint that it has.
std::string jointOf(const Scene& scene, const std::string& body) {
    if (const SwingsMotion* swings = swingOf(scene, body)) return swings->joint;
    for (const SceneJoint& joint : scene.joints)
        if (joint.bodyA == body || joint.bodyB == body) return joint.name;
    notKnown(body, "nothing holds it in the row");
}

/// Refuses contacts. Only in a row that passes its swing on may equal discs side by side touch.
void refuseMeetings(const Scene& scene, const SwingsMotion& motion, const Hung& hung) {
    const SceneBody& own = *hung.body.scene;
    const bool inRow = motion.side != Side::Both || !motion.after.empty();
    bool beside = false;
    for (const SceneBody& other : scene.bodies) {
        if (&other == &own || !mayTouch(own.def, other.def)) continue;
        if (!inRow) {
            if (std::ranges::any_of(scene.joints, [&](const SceneJoint& joint) {
                    return joint.name == motion.joint && (joint.bodyA == other.name || joint.bodyB == other.name);
                }))
                continue;  // joined bodies do not touch
            notKnown(own.name, "it may meet " + other.name);
        }
        const Hung neighbour = hungOf(scene, other.name, jointOf(scene, other.name));
        const PairLaw law = lawOf(own.def.shapes.front(), other.def.shapes.front());
        if (differ(neighbour.body.mass.mass, hung.body.mass.mass) || differ(neighbour.length, hung.length) ||
            differ(neighbour.equivalent, hung.equivalent))
            notKnown(own.name, "it is not like " + other.name + ", which it meets");
        if (law.restitution != 1 || law.friction != 0)
            notKnown(own.name, "it loses something as it meets " + other.name);
        if (neighbour.angle != 0 && hung.angle != 0 && differ(neighbour.angle, hung.angle))
            notKnown(own.name, "it starts at another angle than " + other.name);
        const double apart = (neighbour.pivot - hung.pivot).norm();
        const auto radius = [](const SceneBody& body) {
            const auto* circle = std::get_if<Circle>(&body.def.shapes.front().shape);
            return circle ? circle->radius : 0;
        };
        if (!differ(apart, radius(own) + radius(other))) beside = true;
    }
    if (inRow && !beside) notKnown(own.name, "it touches no other as it hangs");
}

}  // namespace

Hung hungOf(const Scene& scene, const std::string& name, const std::string& joint) {
    Hung hung{.body = heldBodyOf(scene, name)};
    const HeldBody& body = hung.body;
    const std::vector<Holding> holdings = holdingsOf(scene, body);
    const auto by =
        std::ranges::find_if(holdings, [&](const Holding& h) { return scene.joints[h.joint].name == joint; });
    if (by == holdings.end()) notKnown(name, "the joint " + joint + " does not hold it");
    hung.gravity = downwardGravity(body);
    const JointDef& def = scene.joints[by->joint].def;
    const Mass& mass = body.mass;
    Vec2 arm = body.center - by->fixed;
    if (const auto* hinge = std::get_if<RevoluteJointDef>(&def)) {
        if (holdings.size() > 1 || hinge->limit || hinge->spring || hinge->maxMotorTorque > 0)
            notKnown(name, "more than a free hinge holds it");
        const double inertia = body.scene->def.fixedRotation ? 0 : mass.inertia;
        if (body.scene->def.fixedRotation) notKnown(name, "it cannot turn on its hinge");
        hung.equivalent = (inertia + mass.mass * arm.squaredNorm()) / (mass.mass * arm.norm());
        hung.turns = true;
    } else {
        for (const Holding& h : holdings) {
            const auto* rod = std::get_if<DistanceJointDef>(&scene.joints[h.joint].def);
            const Vec2 along = h.held - h.fixed;
            if (!rod || rod->spring || differ(rod->length.value_or(along.norm()), along.norm()) ||
                (along - (by->held - by->fixed)).norm() > alike)
                notKnown(name, "more than rods side by side holds it");
        }
        arm = by->held - by->fixed;
        if (holdings.size() == 1 && (by->held - body.center).norm() > alike)
            notKnown(name, "its rod holds it off its centre of mass");
        hung.equivalent = arm.norm();
    }
    hung.length = arm.norm();
    const Vec2 origin = body.scene->def.position;
    hung.pivot = hung.turns ? by->fixed : Vec2(origin - arm);
    hung.angle = std::atan2(arm.x(), -arm.y());
    if (hung.turns && (origin - body.center).norm() > alike) notKnown(name, "its origin is not its centre of mass");
    return hung;
}

WorkedMotion heldMotion(const SwingsMotion& motion, const Scene& scene) {
    const Hung hung = hungOf(scene, motion.body, motion.joint);
    const BodyDef& def = hung.body.scene->def;
    if (def.velocity != Vec2(0, 0) || def.angularVelocity != 0) notKnown(motion.body, "it does not start at rest");
    refuseMeetings(scene, motion, hung);
    double amplitude = hung.angle;
    if (!motion.after.empty()) {
        if (std::abs(hung.angle) > alike) notKnown(motion.body, "it takes over a swing, and does not hang still");
        amplitude = hungOf(scene, motion.after, jointOf(scene, motion.after)).angle;
    }
    return {PendulumMotion{.body = motion.body,
                           .pivot = hung.pivot,
                           .length = hung.length,
                           .equivalentLength = hung.equivalent,
                           .gravity = hung.gravity,
                           .amplitude = amplitude,
                           .bodyAngle = def.angle,
                           .turns = hung.turns,
                           .side = motion.side}};
}

}  // namespace plumb::compare
