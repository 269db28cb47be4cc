// SPDX-License-Identifier: MIT
// What is a world made of, behind its door?
#pragma once
#include <map>
#include <optional>
#include <vector>

#include <plumb/dynamics/detail/audit.h>
#include <plumb/dynamics/detail/body_store.h>
#include <plumb/dynamics/detail/contact_graph.h>
#include <plumb/dynamics/detail/contact_store.h>
#include <plumb/dynamics/detail/field_store.h>
#include <plumb/dynamics/detail/joint_net.h>
#include <plumb/dynamics/detail/joint_springs.h>
#include <plumb/dynamics/detail/joint_store.h>
#include <plumb/dynamics/detail/joint_system.h>
#include <plumb/dynamics/detail/lane_collider.h>
#include <plumb/dynamics/detail/sensor_store.h>
#include <plumb/dynamics/detail/strays.h>
#include <plumb/dynamics/detail/tile_shapes.h>
#include <plumb/dynamics/world.h>
#include <plumb/space/space.h>

namespace plumb {

/// What the impacts have flown a body in this step, from one to the next.
struct Leg {
    BodyIndex body = noBody;
    BodyMotion from, to;
    double start = 0, end = 0;  ///< in the step [s]
};

struct WorldState {
    WorldDef def;
    std::uint32_t id = 0;
    double lastStep = 0;  ///< dt of the last step that took time [s]
    StepProfile profile;

    BodyStore bodies;
    std::map<BodyIndex, Mass> parkedMass;  ///< given to bodies that are not dynamic now
    Space space;
    TileStore tiles;
    std::uint32_t walls = 0;  ///< shapes that nothing pushes: those of static and kinematic bodies, but for sensors
    ContactStore contacts;
    ContactGraph graph;
    SensorStore sensors;
    std::vector<Leg> legs;                     ///< each body's in the order of time
    const JointSystem* jointSystem = nullptr;  ///< none before the first joint
    JointStore joints;
    std::vector<JointNet> nets;           ///< of what is awake
    std::vector<JointIndex> awakeJoints;  ///< those of the nets, in the order of their slots
    std::vector<JointIndex> breakable;    ///< those of them that may break
    bool jointsChanged = false;           ///< nets and awakeJoints are out of date
    JointSprings springs;
    FieldStore fields;

    std::vector<ContactBegin> begins;
    std::vector<ContactEnd> ends;
    std::size_t reportedEnds = 0;  ///< of ends: those of the last step; what was removed since comes after them
    std::vector<JointBroke> breaks;
    std::vector<ContactHit> hits;
    std::vector<Quarantined> quarantines;
    std::vector<BodyIndex> movers;       ///< those that were awake in the last step
    std::vector<BodyIndex> sleepers;     ///< of those: they fell asleep at its end
    std::vector<BodyIndex> gone;         ///< slots of bodies that were removed since
    std::vector<BodyIndex> unsound;      ///< to be put in quarantine
    std::vector<ContactIndex> isolated;  ///< contacts left to the impacts in the last step that had such
    const LaneCollider* collider = nullptr;
    std::optional<Audit> audit;  ///< if WorldDef.ledger asks for one
    Strays strays;

    BodyId idOf(BodyIndex body) const { return {body, bodies.record[body].generation, id}; }
    ShapeId idOfShape(ProxyId proxy) const { return {idOf(space[proxy].owner), space[proxy].number}; }
    const Proxy& proxyA(const ContactRecord& c) const { return space[c.proxyA]; }
    const Proxy& proxyB(const ContactRecord& c) const { return space[c.proxyB]; }
};

/// Where a body is, seen so many rounds on.
inline BodyMotion shifted(const BodyMotion& motion, const Vec2& shift) {
    BodyMotion seen = motion;
    seen.center += shift;
    return seen;
}
inline Transform shifted(const Transform& pose, const Vec2& shift) {
    return {pose.position + shift, pose.rotation};
}

/// Gives a body a new place and speed; one out of the range of sound numbers stays where it is, marked for quarantine.
void moveTo(WorldState& world, BodyIndex body, const BodyMotion& motion);
/// A contact's normal, and a point half way between the surfaces, in the world, where the bodies are now.
Vec2 normalOf(const WorldState& world, const ContactRecord& contact);
Vec2 pointOf(const WorldState& world, const ContactRecord& contact, std::size_t point);
/// Takes a contact out of the world, with an end event if it was touching.
void removeContact(WorldState& world, ContactIndex contact);

}  // namespace plumb
