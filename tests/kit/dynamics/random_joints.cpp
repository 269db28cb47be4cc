// SPDX-License-Identifier: MIT
// What can be made to hold bodies together, and to let go of them?
#include <algorithm>
#include <sstream>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

constexpr std::size_t mostJoints = 24;

/// What a motor may use: now and then all that it takes.
double strength(RandomEditor& e, double usual) {
    return e.chance(3) ? 0 : e.chance(12) ? infinity : e.amount(usual);
}

std::optional<Spring> anySpring(RandomEditor& e) {
    if (!e.chance(3)) return std::nullopt;
    const double stiffness = e.chance(6) ? 0 : e.amount(200), damping = e.chance(3) ? 0 : e.amount(10);
    return Spring{stiffness, damping};
}

std::optional<Limit> anyLimit(RandomEditor& e) {
    if (!e.chance(3)) return std::nullopt;
    const double lower = e.eitherWay(1), width = e.chance(4) ? 0 : e.amount(1);
    return Limit{e.chance(8) ? -infinity : lower, e.chance(8) ? infinity : lower + width};
}

Breaking anyBreaking(RandomEditor& e) {
    Breaking breaking;
    if (e.chance(8)) breaking.force = e.amount(e.chance(10) ? 1e-3 : 300);
    if (e.chance(12)) breaking.torque = e.amount(e.chance(10) ? 1e-3 : 100);
    return breaking;
}

/// All that a joint can be set to.
template <class Def>
void turnKnobs(RandomEditor& e, Def& d) {
    if constexpr (requires { d.motorSpeed; }) d.motorSpeed = e.chance(2) ? 0 : e.eitherWay(5);
    if constexpr (requires { d.maxMotorTorque; }) d.maxMotorTorque = strength(e, 20);
    if constexpr (requires { d.maxMotorForce; }) d.maxMotorForce = strength(e, 100);
    if constexpr (requires { d.limit; }) d.limit = anyLimit(e);
    if constexpr (requires { d.spring; }) d.spring = anySpring(e);
    if constexpr (requires { d.bending; }) d.bending = anySpring(e);
    if constexpr (requires { d.restAngle; }) d.restAngle = e.eitherWay(1);
    if constexpr (requires { d.restShift; }) d.restShift = e.eitherWay(1);
    if constexpr (requires { d.length; }) {
        if (e.chance(2)) d.length = e.amount(4);
        d.minLength = e.chance(3) ? e.amount(2) : 0;
        d.maxLength = e.chance(2) ? infinity : e.chance(6) ? d.minLength : d.minLength + e.amount(4);
    }
    if constexpr (requires { d.ratio; }) d.ratio = e.chance(2) ? 1 : e.amount(3);
    if constexpr (requires { d.rate; }) {
        d.rate = e.chance(4) ? 0 : e.amount(20);
        d.velocity = e.chance(3) ? e.vector(3) : Vec2(0, 0);
        d.angularVelocity = e.chance(3) ? e.eitherWay(3) : 0;
        if (e.chance(3)) d.offset = e.vector(3);
        if (e.chance(3)) d.angle = e.eitherWay(2);
        d.maxTorque = strength(e, 50);
    }
    if constexpr (requires { d.target; }) d.target = e.vector(e.goesWild() ? 1e16 : 8) + Vec2(0, 5);
    if constexpr (requires { d.maxForce; }) d.maxForce = strength(e, 500);
    if constexpr (requires { d.collideConnected; }) d.collideConnected = e.chance(3);
    if constexpr (requires { d.breaking; }) d.breaking = anyBreaking(e);
}

/// Takes back what a new joint may not have, because it could do nothing.
template <class Def>
void leaveOutIdle(Def& d) {
    if constexpr (requires { d.maxLength; })
        if (!d.spring) d.minLength = 0, d.maxLength = infinity, d.maxMotorForce = 0;
    if constexpr (requires { d.restAngle; })
        if (!d.spring) d.restAngle = 0;
    if constexpr (requires { d.restShift; })
        if (!d.spring) d.restShift = 0;
    if constexpr (requires { d.maxMotorTorque; })
        if (d.maxMotorTorque == 0) d.motorSpeed = 0;
    if constexpr (requires { d.maxMotorForce; })
        if (d.maxMotorForce == 0) d.motorSpeed = 0;
}

/// Of some others the nearest, so that not every joint spans the world.
BodyId neighbourOf(RandomEditor& e, const BodyId& body) {
    const Vec2 here = e.world.body(body).position();
    BodyId nearest = e.someBody();
    for (int i = 0; i < 5; ++i) {
        const BodyId other = e.someBody();
        const double now = (e.world.body(nearest).position() - here).norm();
        if (nearest == body || (other != body && (e.world.body(other).position() - here).norm() < now)) nearest = other;
    }
    return nearest;
}

Vec2 anchorOn(RandomEditor& e, const BodyId& body) {
    const Vec2 off = e.vector(e.goesWild() ? e.oneOf<double>({1e2, 1e4, 1e5, 1e6}) : 0.6);
    return e.world.body(body).position() + off;
}

/// Which bodies or joints it holds, and where.
template <class Def>
void place(RandomEditor& e, Def& d) {
    if constexpr (requires { d.bodyA; }) {
        d.bodyA = e.someBody();
        d.bodyB = neighbourOf(e, d.bodyA);
        if (e.chance(2)) std::swap(d.bodyA, d.bodyB);
    }
    if constexpr (requires { d.body; }) d.body = e.someBody();
    if constexpr (requires { d.anchor; }) {
        if constexpr (requires { d.body; })
            d.anchor = anchorOn(e, d.body);
        else
            d.anchor = anchorOn(e, e.chance(2) ? d.bodyA : d.bodyB);
    }
    if constexpr (requires { d.anchorA; }) d.anchorA = anchorOn(e, d.bodyA), d.anchorB = anchorOn(e, d.bodyB);
    if constexpr (requires { d.groundA; }) {
        d.groundA = d.anchorA + e.vector(1) + Vec2(0, 3);
        d.groundB = d.anchorB + e.vector(1) + Vec2(0, 3);
    }
    if constexpr (requires { d.axis; }) d.axis = e.vector(1);
    if constexpr (requires { d.jointA; }) {
        if (e.joints.empty()) return;
        d.jointA = e.oneOf(e.joints).id;
        d.jointB = e.oneOf(e.joints).id;
    }
}

template <class Def>
RandomEditor::Joined joinedBy(const JointId& id, const Def& d) {
    RandomEditor::Joined joined{id, {}, {}, {}};
    if constexpr (requires { d.bodyA; }) joined.bodies = {d.bodyA, d.bodyB};
    if constexpr (requires { d.body; }) joined.bodies = {d.body};
    if constexpr (requires { d.jointA; }) joined.drivers = {d.jointA, d.jointB};
    if constexpr (requires { d.breaking; }) joined.breaking = d.breaking;
    return joined;
}

template <class Def>
void joinBy(RandomEditor& e) {
    Def def;
    place(e, def);
    turnKnobs(e, def);
    leaveOutIdle(def);
    JointId id;
    if (!e.tryTo([&] { id = e.world.join(def); })) return;
    if (!e.world.contains(id)) FAIL("a joint that was made is not there");
    if (!std::holds_alternative<Def>(e.world.joint(id).def())) FAIL("a joint is of another kind");
    e.joints.push_back(joinedBy(id, def));
    ++e.tally.joints;
    e.tally.gears += std::is_same_v<Def, GearJointDef> ? 1 : 0;
}

/// Two hinges or slides are not often drawn: so a gear looks for them.
void joinGear(RandomEditor& e) {
    for (int i = 0; i < 10; ++i) joinBy<GearJointDef>(e);
}

void joinBodies(RandomEditor& e) {
    if (e.joints.size() >= mostJoints) return e.removeJoint(e.oneOf(e.joints).id);
    switch (e.random.integer(0, 11)) {
        case 0: return joinBy<PrismaticJointDef>(e);
        case 1: return joinBy<DistanceJointDef>(e);
        case 2: return joinBy<WeldJointDef>(e);
        case 3: return joinBy<WheelJointDef>(e);
        case 4: return joinBy<PulleyJointDef>(e);
        case 5: return joinBy<MotorJointDef>(e);
        case 6: return joinBy<TargetJointDef>(e);
        case 7: return joinBy<FilterJointDef>(e);
        case 8: return joinGear(e);
        default: return joinBy<RevoluteJointDef>(e);
    }
}

void removeJoint(RandomEditor& e) {
    if (!e.joints.empty()) e.removeJoint(e.oneOf(e.joints).id);
}

void setJoint(RandomEditor& e) {
    if (e.joints.empty()) return;
    const std::size_t at = static_cast<std::size_t>(e.random.integer(0, static_cast<int>(e.joints.size()) - 1));
    RandomEditor::Joined& joined = e.joints[at];
    Joint joint = e.world.joint(joined.id);
    JointDef def = joint.def();
    const bool moves = e.chance(10);
    std::visit(
        [&](auto& d) {
            turnKnobs(e, d);
            if constexpr (requires { d.axis; }) {
                if (moves) d.axis += Vec2(1, 2);
            } else if constexpr (requires { d.bodyB; }) {
                if (moves) d.bodyB = {d.bodyB.index + 1, d.bodyB.generation, d.bodyB.world};
            }
        },
        def);
    const bool unmoved = std::holds_alternative<TargetJointDef>(def) || std::holds_alternative<GearJointDef>(def);
    if (!e.tryTo([&] { joint.set(def); })) return;
    if (moves && !unmoved) FAIL("a joint was set to hold elsewhere");
    std::visit([&](const auto& d) { joined = joinedBy(joined.id, d); }, def);
}

std::string textOf(const World& world, const RandomEditor::Joined& joined) {
    const JointView joint = world.joint(joined.id);
    const JointReaction reaction = joint.reaction();
    std::ostringstream text;
    text << "kind " << joint.def().index() << ", " << reaction.force.transpose() << " N of " << joined.breaking.force
         << ", " << reaction.torque << " N m of " << joined.breaking.torque << ", error " << joint.error();
    for (const BodyId& id : joined.bodies) {
        const BodyView body = world.body(id);
        text << "; body " << id.index << " of type " << static_cast<int>(body.type()) << " at "
             << body.position().transpose() << " m, " << body.velocity().transpose() << " m/s, "
             << body.angularVelocity() << " rad/s, " << body.mass() << " kg" << (body.awake() ? ", awake" : "")
             << (body.enabled() ? "" : ", disabled") << (body.quarantined() ? ", quarantined" : "");
    }
    return text.str();
}

void readJoint(RandomEditor& e) {
    if (e.joints.empty()) return;
    const World& world = e.world;
    const RandomEditor::Joined& joined = e.oneOf(e.joints);
    const JointView joint = world.joint(joined.id);
    const JointReaction reaction = joint.reaction();
    const JointCoordinate coordinate = joint.coordinate();
    for (const double number :
         {reaction.force.x(), reaction.force.y(), reaction.torque, coordinate.value, coordinate.speed, joint.error()}) {
        if (!std::isfinite(number)) FAIL("a joint says what is no number: " << textOf(world, joined));
        e.hear(number);
    }
}

/// Ratios of masses that no solver likes.
void weigh(RandomEditor& e) {
    Body body = e.some();
    const double mass = e.amount(5), arm = e.amount(1);
    e.tryTo([&] { body.setMass({mass, e.vector(0.2), mass * arm * arm}); });
}

bool isGear(const RandomEditor::Joined& joint) {
    return !joint.drivers.empty();
}

/// It bears no more than it can, as long as it is solved.
bool holdsOut(const World& world, const RandomEditor::Joined& joint) {
    const JointReaction reaction = world.joint(joint.id).reaction();
    if (!reaction.force.allFinite() || !std::isfinite(reaction.torque)) return false;
    if (reaction.force.norm() <= joint.breaking.force && std::fabs(reaction.torque) <= joint.breaking.torque)
        return true;
    return std::none_of(joint.bodies.begin(), joint.bodies.end(),
                        [&](const BodyId& body) { return world.body(body).awake(); });
}

/// Two that may not touch do not, and no one of two that are joined sleeps alone.
void checkPair(const JointDef& def, const BodyView& a, const BodyView& b) {
    const bool free = std::visit(
        []<class Def>(const Def& d) {
            if constexpr (requires { d.collideConnected; }) return d.collideConnected;
            return !std::is_same_v<Def, FilterJointDef>;
        },
        def);
    for (const Contact& contact : a.contacts())
        if (!free && (contact.shapeA.body == b.id() || contact.shapeB.body == b.id())) FAIL("joined bodies touch");
    if (std::holds_alternative<FilterJointDef>(def)) return;
    const auto moves = [](const BodyView& body) { return body.enabled() && body.type() == BodyType::Dynamic; };
    if (moves(a) && moves(b) && a.awake() != b.awake()) FAIL("one of two that are joined sleeps alone");
}

}  // namespace

void RandomEditor::removeJoint(JointId joint) {
    world.remove(joint);
    if (world.contains(joint)) FAIL("a removed joint is there");
    forgetJoint(joint);
}

void RandomEditor::forgetJoint(JointId joint) {
    std::erase_if(joints, [&](const Joined& other) { return other.id == joint; });
    unjoined.push_back(joint);
    const auto driven = [&](const Joined& other) {
        return std::find(other.drivers.begin(), other.drivers.end(), joint) != other.drivers.end();
    };
    for (auto gear = std::find_if(joints.begin(), joints.end(), driven); gear != joints.end();
         gear = std::find_if(joints.begin(), joints.end(), driven))
        forgetJoint(gear->id);
}

void RandomEditor::forgetJointsOf(BodyId body) {
    const std::vector<Joined> before = joints;
    for (const Joined& joint : before)
        if (std::find(joint.bodies.begin(), joint.bodies.end(), body) != joint.bodies.end()) forgetJoint(joint.id);
}

/// Whatever broke was there, bore too much and is gone; with what hung on it, but that is not told.
void RandomEditor::followBreaks() {
    const std::vector<Joined> before = joints;
    for (const JointBroke& broke : world.jointBreaks()) {
        const auto joint =
            std::find_if(before.begin(), before.end(), [&](const Joined& other) { return other.id == broke.joint; });
        if (joint == before.end()) FAIL("what was not there broke");
        if (world.contains(broke.joint)) FAIL("what broke is there");
        const Breaking& most = joint->breaking;
        if (!(broke.force.norm() > most.force) && !(std::fabs(broke.torque) > most.torque)) FAIL("it broke too soon");
        if (!broke.force.allFinite() || !std::isfinite(broke.torque)) FAIL("it broke of what is no number");
        if (!isGear(*joint) && broke.bodyB != joint->bodies.back()) FAIL("what broke held another body");
        forgetJoint(broke.joint);
        ++tally.breaks;
    }
    if (lastStep_ < 1e-9) return;
    for (const Joined& joint : joints)
        if (!holdsOut(world, joint)) FAIL("it bears more than it can, or what is no number: " << textOf(world, joint));
}

/// Joints are those that were made, less those removed or broken.
void RandomEditor::checkJoints() {
    std::vector<JointId> made;
    for (const Joined& joint : joints) made.push_back(joint.id);
    std::sort(made.begin(), made.end(), [](const JointId& a, const JointId& b) { return a.index < b.index; });
    if (world.joints() != made || world.counts().joints != made.size()) FAIL("joints are not those that were made");
    for (const JointId& joint : unjoined)
        if (world.contains(joint)) FAIL("a removed joint is there");
    for (const Joined& joint : joints) {
        const JointView view = std::as_const(world).joint(joint.id);
        // Of what was put where no body can be there is no saying how far off it is.
        const auto beyond = [&](const BodyId& body) { return !(world.body(body).position().norm() < 1e15); };
        const bool sound = std::none_of(joint.bodies.begin(), joint.bodies.end(), beyond) && !isGear(joint);
        if (sound && (!(view.error() >= 0) || !std::isfinite(view.error()))) FAIL("an error that is none");
        if (joint.bodies.size() == 2) checkPair(view.def(), world.body(joint.bodies[0]), world.body(joint.bodies[1]));
    }
    std::map<std::uint32_t, std::vector<JointId>> held;
    for (const JointId& id : made) {
        const auto joint = std::find_if(joints.begin(), joints.end(), [&](const Joined& j) { return j.id == id; });
        for (const BodyId& body : joint->bodies) held[body.index].push_back(id);
    }
    for (const BodyId& body : bodies) {
        std::vector<JointId> told = world.body(body).joints();
        std::sort(told.begin(), told.end(), [](const JointId& a, const JointId& b) { return a.index < b.index; });
        if (std::adjacent_find(told.begin(), told.end()) != told.end()) FAIL("a body names a joint twice");
        std::erase_if(told,
                      [&](const JointId& id) { return std::holds_alternative<GearJointDef>(world.joint(id).def()); });
        if (told != held[body.index]) FAIL("a body's joints are not those that hold it");
    }
}

std::vector<RandomEditor::Action> jointActions() {
    return {{30, joinBodies}, {6, removeJoint}, {20, setJoint}, {10, readJoint}, {2, weigh}};
}

}  // namespace plumb::test
