// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body.h>

#include <plumb/dynamics/edit/body_shapes.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/jointed/island_solver.h>
#include <plumb/dynamics/state/world_state.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// The mass of a body that becomes dynamic; throws if it has none.
Mass massWhenDynamic(const WorldState& world, BodyIndex body) {
    const auto parked = world.parkedMass.find(body);
    if (parked != world.parkedMass.end()) return parked->second;
    const Mass mass = massOfShapes(world, body);
    requireMass(mass, "Body.setType: Dynamic, for the shapes'",
                "a dynamic body needs a shape with area and density, or a mass of its own");
    return mass;
}

void requireThicknessWhenDynamic(const WorldState& world, BodyIndex body) {
    std::vector<ShapeDef> shapes;
    for (const ProxyId proxy : world.bodies.links[body].proxies) shapes.push_back(world.space[proxy].def);
    requireThickness(shapes, "Body.setType: Dynamic, for the shapes");
}

/// Changes the mass of a body. For a body that is not dynamic, a parked mass is kept until it is dynamic again.
void changeMass(WorldState& world, BodyIndex body, const Mass& mass) {
    const BodyRecord& record = world.bodies.record[body];
    if (record.type == BodyType::Dynamic) world.parkedMass.erase(body);
    giveMass(world, body, mass);
}

void requireDynamic(const WorldState& world, BodyIndex body, const char* what) {
    if (!world.bodies.isDynamic(body))
        refuse(what, "the body is not dynamic, but " + nameOf(world.bodies.record[body].type) + ", and has no mass");
}

/// Wakes a body if it can be moved or moves by itself.
void wakeIfMoving(WorldState& world, BodyIndex body) {
    const BodyMotion& motion = world.bodies.motion[body];
    wakeIsland(world, body);
    if (!motion.velocity.isZero(0) || motion.angularVelocity != 0) world.bodies.wake(body);
}

}  // namespace

/// All checks come first. Shapes are hidden and shown again, because a body's type decides which of its pairs become
/// contacts; in between the body sleeps, in no list. A given mass is parked until the body is dynamic again. Tests: "a
/// body of any type made another goes on as one that was added as that", "a given mass outlasts new shapes and a time
/// as a static body"
void Body::setType(BodyType type) {
    requireType(type, "Body.setType: type");
    WorldState& world = *world_;
    BodyRecord& record = world.bodies.record[index()];
    if (type == record.type) return;
    if (type == BodyType::Dynamic) requireThicknessWhenDynamic(world, index());
    const Mass mass = type == BodyType::Dynamic ? massWhenDynamic(world, index()) : Mass{};
    if (world.bodies.isDynamic(index()) && record.massGiven)
        world.parkedMass[index()] = {record.mass, record.localCenter, record.inertia};
    const bool enabled = record.enabled;
    wakeNeighbours(world, index());
    if (enabled) hideShapes(world, index());
    world.bodies.putToSleep(index());
    std::erase(world.bodies.kinematic, index());
    record.type = type;
    if (type == BodyType::Kinematic) world.bodies.kinematic.push_back(index());
    changeMass(world, index(), mass);
    fixShapes(world, index());
    BodyMotion& motion = world.bodies.motion[index()];
    if (type == BodyType::Static) {
        motion.velocity.setZero();
        motion.angularVelocity = 0;
    }
    world.bodies.rest(index());
    world.joints.noteEdits(world.bodies.links[index()].joints);
    if (!enabled) return;
    showShapes(world, index());
    wakeIfMoving(world, index());
    wakeNeighbours(world, index());
}

void Body::setMass(const Mass& mass) {
    requireDynamic(*world_, index(), "Body.setMass");
    requireMass(mass, "Body.setMass: mass");
    world_->bodies.record[index()].massGiven = true;
    giveMass(*world_, index(), mass);
    wakeIsland(*world_, index());
}

void Body::setMassFromShapes() {
    requireDynamic(*world_, index(), "Body.setMassFromShapes");
    const Mass mass = massOfShapes(*world_, index());
    requireMass(mass, "Body.setMassFromShapes: the shapes'", "they have no area or no density");
    world_->bodies.record[index()].massGiven = false;
    giveMass(*world_, index(), mass);
    wakeIsland(*world_, index());
}

void Body::setGravityScale(double scale) {
    requireFinite(scale, "Body.setGravityScale: scale");
    world_->bodies.record[index()].gravityScale = scale;
    wakeIsland(*world_, index());
}

void Body::setLinearDamping(double damping) {
    requireNotNegative(damping, "Body.setLinearDamping: damping");
    world_->bodies.record[index()].linearDamping = damping;
}

void Body::setAngularDamping(double damping) {
    requireNotNegative(damping, "Body.setAngularDamping: damping");
    world_->bodies.record[index()].angularDamping = damping;
}

void Body::setFixedRotation(bool fixed) {
    BodyRecord& record = world_->bodies.record[index()];
    if (fixed == record.fixedRotation) return;
    record.fixedRotation = fixed;
    BodyMotion& motion = world_->bodies.motion[index()];
    if (fixed) motion.angularVelocity = 0;
    giveMass(*world_, index(), {record.mass, record.localCenter, record.inertia});
    if (record.type == BodyType::Kinematic && motion.velocity.isZero(0) && motion.angularVelocity == 0)
        sleepIsland(*world_, index());
    wakeIsland(*world_, index());
    wakeNeighbours(*world_, index());
}

void Body::setLocks(bool lockX, bool lockY) {
    lockBody(*world_, index(), lockX, lockY, islandSolver());
}

void Body::setCanSleep(bool canSleep) {
    world_->bodies.record[index()].canSleep = canSleep;
    if (!canSleep) wakeIsland(*world_, index());
}

void Body::wake() {
    wakeIsland(*world_, index());
}

void Body::sleep() {
    sleepIsland(*world_, index());
}

/// Both sides of the change wake what it concerns: neighbours, and what a magnet on the body draws. A body in
/// quarantine is let out by this.
void Body::setEnabled(bool enabled) {
    WorldState& world = *world_;
    BodyRecord& record = world.bodies.record[index()];
    if (enabled == record.enabled) return;
    wakeNeighbours(world, index());
    wakeInfluencedByMagnetsOn(world, index());
    if (enabled) {
        record.quarantined = false;
        showShapes(world, index());
        wakeIfMoving(world, index());
        wakeInfluencedByMagnetsOn(world, index());
        return;
    }
    hideShapes(world, index());
    world.bodies.putToSleep(index());
}

void Body::setTag(std::uint64_t tag) {
    world_->bodies.record[index()].tag = tag;
}

}  // namespace plumb
