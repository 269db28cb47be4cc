// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/joint_edits.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

namespace {

struct JointBodies {
    BodyIndex a = noBody, b = noBody;
    bool collideConnected = true;
    Breaking breaking;
};

/// Which bodies a joint links, and whether they may touch. A gear acts on the second bodies of its two joints; a target
/// has one body and the world.
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

/// Once for each joint that forbids contacts, so the pair stays apart until the last of them is gone.
void keepApart(BodyStore& bodies, BodyIndex a, BodyIndex b) {
    bodies.apart[a].push_back(b);
    bodies.apart[b].push_back(a);
}

void keepApartNoMore(BodyStore& bodies, BodyIndex a, BodyIndex b) {
    const auto eraseOne = [](std::vector<BodyIndex>& from, BodyIndex body) {
        from.erase(std::find(from.begin(), from.end(), body));
    };
    eraseOne(bodies.apart[a], b);
    eraseOne(bodies.apart[b], a);
}

/// A new record. The first one brings the solver: a program without joints does not link its code (joint_solver.h).
JointIndex acquire(WorldState& world, const JointSolver& solver) {
    if (world.joints.records.empty()) world.jointSolver = solver.copy();
    return world.joints.acquire();
}

/// Enters a joint with its bodies. Contacts that the joint forbids go at once.
void link(WorldState& world, JointIndex index) {
    const JointRecord& record = world.joints[index];
    world.joints.changed = true;
    forEachBody(world.joints, index, [&](BodyIndex body) {
        world.bodies.links[body].joints.push_back(index);
        if (record.acts()) ++world.bodies.links[body].actingJoints;
    });
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
    if (record.collideConnected) return;
    keepApart(world.bodies, record.bodyA, record.bodyB);
    forEachContact(world.bodies, world.contacts, record.bodyA, [&](ContactIndex between) {
        const ContactRecord& contact = world.contacts[between];
        if (contact.bodyA == record.bodyB || contact.bodyB == record.bodyB) removeContact(world, between);
    });
}

/// The reverse of link. Bodies get the inertia of their own again, because a stiff joint may have set another. Bodies
/// that may touch again may have been near all the time, and then the broad phase does not report them as new: their
/// pairs are added here. Test: "bodies joined without collideConnected pass through each other until the joint is
/// removed"
void unlink(WorldState& world, JointIndex index) {
    const JointRecord& record = world.joints[index];
    BodyStore& bodies = world.bodies;
    world.joints.changed = true;
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
    forEachBody(world.joints, index, [&](BodyIndex body) {
        BodyLinks& links = bodies.links[body];
        links.joints.erase(std::find(links.joints.begin(), links.joints.end(), index));
        if (record.acts()) --links.actingJoints;
        if (bodies.isDynamic(body)) setGyration(bodies.record[body], bodies.record[body].inverseInertia);
    });
    if (record.collideConnected) return;
    keepApartNoMore(bodies, record.bodyA, record.bodyB);
    addPairs(world, pairsOfBodies(bodies, world.space, record.bodyA, record.bodyB));
}

template <class Visit>
void forEachLock(WorldState& world, BodyIndex body, Visit&& visit) {
    const std::vector<JointIndex> joints = world.bodies.links[body].joints;
    for (const JointIndex index : joints)
        if (auto* lock = std::get_if<LockJoint>(&world.joints[index].joint)) visit(index, *lock);
}

void moveLocks(WorldState& world, BodyIndex body) {
    forEachLock(world, body, [&](JointIndex index, LockJoint& lock) {
        lock.setCenter(world.bodies.motion[body].center);
        world.joints.noteEdit(index);
    });
}

/// Else a joint would pull a body that was put over the seam all the way back around the world.
void takeNearestImages(WorldState& world, BodyIndex body) {
    const BodyStore& bodies = world.bodies;
    if (!bodies.wrap.any()) return;
    const auto bring = [&](Anchor& anchor, const Vec2& to) {
        anchor.shift += bodies.wrap.shiftNear(endAtRest(anchor, bodies).point, to);
    };
    for (const JointIndex index : bodies.links[body].joints) {
        world.joints.noteEdit(index);
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
}

}  // namespace

JointIndex addJoint(WorldState& world, const JointDef& def, const JointSolver& solver) {
    const JointIndex index = acquire(world, solver);
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

/// A gear cannot outlive the joints that it drives. The list is copied, because release changes it.
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

/// Keeps the joint's impulses as first guess. Only collideConnected changes what link has entered, so only then it is
/// linked anew.
void changeJoint(WorldState& world, JointIndex index, const JointDef& def) {
    JointRecord& record = world.joints[index];
    const JointBodies bodies = bodiesOf(world, def);
    if (bodies.collideConnected != record.collideConnected) {
        unlink(world, index);
        record.collideConnected = bodies.collideConnected;
        link(world, index);
    }
    record.breaking = bodies.breaking;
    world.joints.noteEdit(index);
    changeJoint(record.joint, def, world.joints, world.bodies);
    forEachBody(world.joints, index, [&](BodyIndex body) { wakeIsland(world, body); });
}

void removeJointsOf(WorldState& world, BodyIndex body) {
    while (!world.bodies.links[body].joints.empty()) removeJoint(world, world.bodies.links[body].joints.back());
}

/// First all joints are compared with their limits, then the broken ones removed: so it does not matter which comes
/// first, and a gear that broke may be gone already with one of its joints. O(joints that can break).
void breakJoints(WorldState& world) {
    std::vector<JointIndex> broken;
    for (const JointIndex index : world.jointSolver->breakable()) {
        const JointRecord& record = world.joints[index];
        const JointLoad& load = world.joints.loads[index];
        if (!load.force().allFinite() || !std::isfinite(load.torque())) continue;  // its bodies go, the joint stays
        if (load.force().norm() <= record.breaking.force && std::abs(load.torque()) <= record.breaking.torque) continue;
        const auto idOrNone = [&](BodyIndex body) { return body == noBody ? BodyId{} : world.bodies.idOf(body); };
        world.events.breaks.push_back({JointId{index, record.generation, world.bodies.world}, idOrNone(record.bodyA),
                                       idOrNone(record.bodyB), load.force(), load.torque()});
        broken.push_back(index);
    }
    for (const JointIndex index : broken)
        if (!world.joints[index].isFree()) removeJoint(world, index);
}

/// A lock is a hidden joint to the world, which World::joints does not list.
void lockBody(WorldState& world, BodyIndex body, bool lockX, bool lockY, const JointSolver& solver) {
    forEachLock(world, body, [&](JointIndex index, const LockJoint&) { removeJoint(world, index); });
    if (!lockX && !lockY) return;
    const JointIndex index = acquire(world, solver);
    JointRecord& record = world.joints[index];
    record.joint = LockJoint(body, lockX, lockY, world.bodies);
    record.bodyB = body;
    record.collideConnected = true;
    link(world, index);
}

void followMove(WorldState& world, BodyIndex body) {
    moveLocks(world, body);
    takeNearestImages(world, body);
}

void shiftAnchors(WorldState& world, BodyIndex body, const Vec2& shift) {
    for (const JointIndex index : world.bodies.links[body].joints) {
        world.joints.noteEdit(index);
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
