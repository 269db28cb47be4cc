// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/joints_edit.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/joint_bodies.h>
#include <plumb/dynamics/detail/pairs.h>

namespace plumb {

namespace {

struct JointBodies {
    BodyIndex a = noBody, b = noBody;
    bool collideConnected = true;
    Breaking breaking;
};

JointBodies bodiesOf(const WorldState& world, const JointDef& def) {
    return std::visit(
        [&world]<class Def>(const Def& d) -> JointBodies {
            if constexpr (std::is_same_v<Def, GearJointDef>)
                return {world.joints[d.jointA.index].bodyB, world.joints[d.jointB.index].bodyB, true, d.breaking};
            else if constexpr (std::is_same_v<Def, TargetJointDef>)
                return {noBody, d.body.index, true, d.breaking};
            else if constexpr (std::is_same_v<Def, FilterJointDef>)
                return {d.bodyA.index, d.bodyB.index, false, {}};
            else
                return {d.bodyA.index, d.bodyB.index, d.collideConnected, d.breaking};
        },
        def);
}

void link(WorldState& world, JointIndex index) {
    const JointRecord& record = world.joints[index];
    world.jointSystem = &jointSystem;
    world.jointsChanged = true;
    forEachBody(world.joints, index, [&](BodyIndex body) {
        world.bodies.record[body].joints.push_back(index);
        if (record.acts()) ++world.bodies.record[body].actingJoints;
    });
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
    if (record.collideConnected) return;
    forEachContact(world.bodies, world.contacts, record.bodyA, [&](ContactIndex c) {
        const ContactRecord& contact = world.contacts.contacts[c];
        if (contact.bodyA == record.bodyB || contact.bodyB == record.bodyB) removeContact(world, c);
    });
}

void unlink(WorldState& world, JointIndex index) {
    const JointRecord& record = world.joints[index];
    world.jointsChanged = true;
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
    forEachBody(world.joints, index, [&](BodyIndex body) {
        std::vector<JointIndex>& joints = world.bodies.record[body].joints;
        joints.erase(std::find(joints.begin(), joints.end(), index));
        if (record.acts()) --world.bodies.record[body].actingJoints;
        if (world.bodies.isDynamic(body)) setRho(world.bodies.record[body], world.bodies.record[body].inverseInertia);
    });
    if (!record.collideConnected) pairShapes(world, record.bodyA, record.bodyB);
}

/// Gives a joint a def of its own kind.
struct Setter {
    const WorldState& world;
    AnyJoint& joint;
    void operator()(const RevoluteJointDef& d) const { std::get<RevoluteJoint>(joint).set(d); }
    void operator()(const PrismaticJointDef& d) const { std::get<PrismaticJoint>(joint).set(d); }
    void operator()(const DistanceJointDef& d) const { std::get<DistanceJoint>(joint).set(d); }
    void operator()(const WeldJointDef& d) const { std::get<WeldJoint>(joint).set(d); }
    void operator()(const WheelJointDef& d) const { std::get<WheelJoint>(joint).set(d); }
    void operator()(const PulleyJointDef& d) const { std::get<PulleyJoint>(joint).set(d); }
    void operator()(const GearJointDef& d) const {
        std::get<GearJoint>(joint).set(d, world.joints.coordinateOf(d.jointA.index, world.bodies),
                                       world.joints.coordinateOf(d.jointB.index, world.bodies));
    }
    void operator()(const MotorJointDef& d) const { std::get<MotorJoint>(joint).set(d); }
    void operator()(const TargetJointDef& d) const { std::get<TargetJoint>(joint).set(d, world.bodies); }
    void operator()(const FilterJointDef& d) const { joint = FilterJoint(d); }
};

template <class Visit>
void forEachLock(WorldState& world, BodyIndex body, Visit&& visit) {
    const std::vector<JointIndex> joints = world.bodies.record[body].joints;
    for (const JointIndex index : joints)
        if (auto* lock = std::get_if<LockJoint>(&world.joints[index].joint)) visit(index, *lock);
}

}  // namespace

JointIndex addJoint(WorldState& world, const JointDef& def) {
    const JointIndex index = world.joints.acquire();
    AnyJoint joint = makeJoint(def, world.joints, world.bodies);
    JointRecord& record = world.joints[index];
    const JointBodies bodies = bodiesOf(world, def);
    record.joint = std::move(joint);
    if (std::holds_alternative<GearJoint>(record.joint)) world.joints.gears.push_back(index);
    record.bodyA = bodies.a;
    record.bodyB = bodies.b;
    record.collideConnected = bodies.collideConnected;
    record.breaking = bodies.breaking;
    link(world, index);
    return index;
}

void removeJoint(WorldState& world, JointIndex joint) {
    const std::vector<JointIndex> gears = world.joints.gears;
    for (const JointIndex other : gears) {
        const GearJoint& gear = std::get<GearJoint>(world.joints[other].joint);
        if (gear.jointA != joint && gear.jointB != joint) continue;
        unlink(world, other);
        world.joints.release(other);
    }
    unlink(world, joint);
    world.joints.release(joint);
}

void changeJoint(WorldState& world, JointIndex index, const JointDef& def) {
    JointRecord& record = world.joints[index];
    const JointBodies bodies = bodiesOf(world, def);
    if (bodies.collideConnected != record.collideConnected) {
        unlink(world, index);
        record.collideConnected = bodies.collideConnected;
        link(world, index);
    }
    record.breaking = bodies.breaking;
    world.jointsChanged = true;
    std::visit(Setter{world, record.joint}, def);
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
}

void removeJointsOf(WorldState& world, BodyIndex body) {
    while (!world.bodies.record[body].joints.empty()) removeJoint(world, world.bodies.record[body].joints.back());
}

void breakJoints(WorldState& world) {
    std::vector<JointIndex> broken;
    for (const JointIndex index : world.breakable) {
        const JointRecord& record = world.joints[index];
        const JointLoad& load = world.joints.loads[index];
        if (!load.force().allFinite() || !std::isfinite(load.torque())) continue;  // its bodies leave, not the joint
        if (load.force().norm() <= record.breaking.force && std::abs(load.torque()) <= record.breaking.torque) continue;
        const auto idOrNone = [&](BodyIndex body) { return body == noBody ? BodyId{} : world.idOf(body); };
        world.breaks.push_back({JointId{index, record.generation, world.id}, idOrNone(record.bodyA),
                                idOrNone(record.bodyB), load.force(), load.torque()});
        broken.push_back(index);
    }
    for (const JointIndex index : broken)
        if (!world.joints[index].isFree()) removeJoint(world, index);
}

void lockBody(WorldState& world, BodyIndex body, bool lockX, bool lockY) {
    forEachLock(world, body, [&](JointIndex index, const LockJoint&) { removeJoint(world, index); });
    if (!lockX && !lockY) return;
    const JointIndex index = world.joints.acquire();
    JointRecord& record = world.joints[index];
    record.joint = LockJoint(body, lockX, lockY, world.bodies);
    record.bodyB = body;
    record.collideConnected = true;
    link(world, index);
}

void moveLocks(WorldState& world, BodyIndex body) {
    forEachLock(world, body, [&](JointIndex, LockJoint& lock) { lock.moveTo(world.bodies.motion[body].center); });
}

void joinNearest(WorldState& world, BodyIndex body) {
    const BodyStore& bodies = world.bodies;
    if (!bodies.wrap.any()) return;
    const auto bring = [&](Anchor& anchor, const Vec2& to) {
        anchor.shift += bodies.wrap.shiftNear(endAtRest(anchor, bodies).point, to);
    };
    for (const JointIndex index : bodies.record[body].joints) {
        AnyJoint& any = world.joints[index].joint;
        if (auto* pulley = std::get_if<PulleyJoint>(&any)) {
            bring(pulley->anchors.a, pulley->def().groundA);
            bring(pulley->anchors.b, pulley->def().groundB);
            continue;
        }
        std::visit(
            [&]<class Joint>(Joint& joint) {
                if constexpr (requires { joint.anchors; })
                    bring(joint.anchors.b, endAtRest(joint.anchors.a, bodies).point);
            },
            any);
    }
    world.jointsChanged = true;
}

void shiftAnchors(WorldState& world, BodyIndex body, const Vec2& shift) {
    for (const JointIndex index : world.bodies.record[body].joints) {
        std::visit(
            [&]<class Joint>(Joint& joint) {
                if constexpr (requires { joint.anchors; }) {
                    if (joint.anchors.a.body == body) joint.anchors.a.local -= shift;
                    if (joint.anchors.b.body == body) joint.anchors.b.local -= shift;
                }
            },
            world.joints[index].joint);
    }
    moveLocks(world, body);
}

}  // namespace plumb
