// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>
#include <compare/formula/atwood.h>

namespace plumb::compare {
namespace {

constexpr double upright = 1e-9;  // up to this distance from a rope's line, a point is on it

/// One end of the rope: how fast it moves upward and how far it can go.
struct RopeEnd {
    HeldBody body{};
    double speed = 0;  ///< upward [m/s]
    double way = 0;    ///< up to its wheel [m]
};

RopeEnd ropeEnd(const Scene& scene, const SceneJoint& joint, bool isB) {
    const auto& rope = std::get<PulleyJointDef>(joint.def);
    RopeEnd end{heldBodyOf(scene, isB ? joint.bodyB : joint.bodyA)};
    const Vec2 wheel = isB ? rope.groundB : rope.groundA, knot = isB ? rope.anchorB : rope.anchorA;
    const std::string& name = end.body.scene->name;
    const BodyDef& def = end.body.scene->def;
    for (const SceneJoint& other : scene.joints)
        if (&other != &joint && (other.bodyA == name || other.bodyB == name))
            notKnown(name, "more than the rope holds it");
    if ((knot - end.body.center).norm() > upright || std::abs(wheel.x() - knot.x()) > upright || wheel.y() <= knot.y())
        notKnown(name, "it does not hang straight below its wheel");
    if (std::abs(def.velocity.x()) > upright || def.angularVelocity != 0) notKnown(name, "it swings or turns");
    end.speed = def.velocity.y();
    end.way = wheel.y() - knot.y();
    return end;
}

/// The time after which a thing with this speed and this acceleration has gone this far; 0 for never.
double timeFor(double way, double speed, double gain) {
    const double square = speed * speed + 2 * gain * way;
    if (square < 0 || (gain <= 0 && speed <= 0)) return 0;
    return 2 * way / (speed + std::sqrt(square));
}

double soonest(double a, double b) {
    return a == 0 ? b : b == 0 ? a : std::min(a, b);
}

/// A wheel or a slide of a gear train, and what drives it.
struct GearPart {
    double weight = 0;   ///< its inertia, or its mass [kg m^2 or kg]
    double push = 0;     ///< torque or force of the motor, with its sign [N m or N]
    double fastest = 0;  ///< the motor's speed [rad/s or m/s]
    Vec2 axis{0, 0};     ///< direction of a slide [-]
    std::string body{};
};

GearPart gearPart(const Scene& scene, const std::string& name, const std::string& asker) {
    const auto joint = std::ranges::find(scene.joints, name, &SceneJoint::name);
    const HeldBody held = heldBodyOf(scene, joint->bodyB);
    const std::vector<Holding> holdings = holdingsOf(scene, held);
    if (held.scene->def.velocity != Vec2(0, 0) || held.scene->def.angularVelocity != 0)
        notKnown(asker, joint->bodyB + " does not start at rest");
    const auto drives = [](double most, double speed) { return speed < 0 ? -most : most; };
    if (const auto* hinge = std::get_if<RevoluteJointDef>(&joint->def)) {
        if (hinge->limit || hinge->spring || (held.center - holdings.at(0).fixed).norm() > upright)
            notKnown(asker, joint->bodyB + " does not turn freely about its centre of mass");
        return {held.mass.inertia,
                drives(hinge->maxMotorTorque, hinge->motorSpeed),
                hinge->motorSpeed,
                {0, 0},
                joint->bodyB};
    }
    const auto* slide = std::get_if<PrismaticJointDef>(&joint->def);
    if (!slide || slide->limit || slide->spring) notKnown(asker, joint->name + " is no free hinge or slide");
    const Vec2 axis = slide->axis.normalized();
    if (std::abs(held.gravity.dot(axis)) > upright) notKnown(asker, "gravity drives " + joint->bodyB);
    return {held.mass.mass, drives(slide->maxMotorForce, slide->motorSpeed), slide->motorSpeed, axis, joint->bodyB};
}

struct GearRatio {
    std::string joint{};
    double ratio = 1;  ///< how far it goes for each step of the first
};

/// All joints that gears couple to this one; a + ratio b = const at each gear.
std::vector<GearRatio> coupledTo(const Scene& scene, const std::string& first) {
    std::vector<GearRatio> coupled{{first, 1}};
    for (std::size_t i = 0; i < coupled.size(); ++i) {
        for (const SceneJoint& joint : scene.joints) {
            const auto* gear = std::get_if<GearJointDef>(&joint.def);
            if (!gear || (joint.jointA != coupled[i].joint && joint.jointB != coupled[i].joint)) continue;
            const bool isA = joint.jointA == coupled[i].joint;
            const std::string& next = isA ? joint.jointB : joint.jointA;
            if (std::ranges::find(coupled, next, &GearRatio::joint) != coupled.end()) continue;
            coupled.push_back({next, isA ? -coupled[i].ratio / gear->ratio : -coupled[i].ratio * gear->ratio});
        }
    }
    return coupled;
}

}  // namespace

WorkedMotion heldMotion(const HoistedMotion& motion, const Scene& scene) {
    const auto joint = std::ranges::find(scene.joints, motion.joint, &SceneJoint::name);
    const auto* rope = std::get_if<PulleyJointDef>(&joint->def);
    if (!rope || (joint->bodyA != motion.body && joint->bodyB != motion.body))
        notKnown(motion.body, "the joint " + motion.joint + " is no rope that holds it");
    const RopeEnd a = ropeEnd(scene, *joint, false), b = ropeEnd(scene, *joint, true);
    const double g = downwardGravity(a.body);
    if (downwardGravity(b.body) != g) notKnown(motion.body, "its ends fall differently");
    if (std::abs(a.speed + rope->ratio * b.speed) > upright) notKnown(motion.body, "the rope does not start taut");
    const double sinks = accelerationOf({a.body.mass.mass, b.body.mass.mass, g, rope->ratio});
    const bool isB = joint->bodyB == motion.body;
    const BodyDef& def = (isB ? b : a).body.scene->def;
    const Vec2 gain(0, isB ? -sinks : rope->ratio * sinks);
    return {PiecewiseMotion{
                motion.body,
                {{.position = def.position, .velocity = def.velocity, .acceleration = gain, .angle = def.angle}}},
            soonest(timeFor(a.way, a.speed, rope->ratio * sinks), timeFor(b.way, b.speed, -sinks))};
}

WorkedMotion heldMotion(const GearedMotion& motion, const Scene& scene) {
    double weight = 0, push = 0, until = 0, fastest = 0, driver = 0;
    for (const GearRatio& part : coupledTo(scene, motion.joint)) {
        const GearPart gear = gearPart(scene, part.joint, motion.body);
        weight += gear.weight * part.ratio * part.ratio;
        push += gear.push * part.ratio;
        if (gear.push == 0) continue;
        if (driver != 0) notKnown(motion.body, "two motors drive it");
        fastest = gear.fastest;
        driver = part.ratio;
    }
    const double gain = push / weight;
    if (driver != 0 && gain != 0) until = fastest / (gain * driver);
    const GearPart own = gearPart(scene, motion.joint, motion.body);
    if (own.body != motion.body) notKnown(motion.body, "the joint " + motion.joint + " does not move it");
    const BodyDef& def = scene.bodies[bodyIndex(scene, motion.body)].def;
    const bool slides = own.axis != Vec2(0, 0);
    return {PiecewiseMotion{motion.body,
                            {{.position = def.position,
                              .acceleration = gain * own.axis,
                              .angle = def.angle,
                              .angularAcceleration = slides ? 0 : gain}}},
            until};
}

}  // namespace plumb::compare
