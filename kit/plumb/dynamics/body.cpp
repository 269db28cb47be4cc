// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body.h>

#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/world_state.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// What a body needs after its velocity was changed from outside: to be awake exactly if it moves or can be moved.
void velocityChanged(WorldState& world, BodyIndex body) {
    if (world.bodies.isDynamic(body)) {
        wakeIsland(world, body);
        return;
    }
    const BodyMotion& motion = world.bodies.motion[body];
    const bool moves = !motion.velocity.isZero(0) || motion.angularVelocity != 0;
    if (moves) {
        world.bodies.wake(body);
        forEachContact(world.bodies, world.contacts, body, [&](ContactIndex c) { world.contacts.addNear(c); });
    } else {
        world.bodies.putToSleep(body);
    }
    wakeNeighbours(world, body);
}

/// Over the next step; noted once, so that forces at rest in a game that pauses cost nothing more.
void addForce(WorldState& world, BodyIndex body, const Vec2& force, double torque) {
    BodyRecord& record = world.bodies.record[body];
    if (record.force.isZero(0) && record.torque == 0) world.bodies.forced.push_back(body);
    record.force += force;
    record.torque += torque;
    wakeIsland(world, body);
}

void requireMovable(const WorldState& world, BodyIndex body, const char* what) {
    if (world.bodies.record[body].type == BodyType::Static)
        refuse(what, "the body is static (or in quarantine), and stays where it is");
}

Contact contactOf(const WorldState& world, const ContactRecord& record) {
    Contact contact{world.idOfShape(record.proxyA), world.idOfShape(record.proxyB), normalOf(world, record), {}};
    const double time = record.colour >= 0 ? world.lastStep : record.memoryStep;
    const auto memory = world.graph.memoryOf(record);
    for (std::size_t p = 0; p < static_cast<std::size_t>(world.graph.manifoldOf(record).count); ++p) {
        ContactPoint out{pointOf(world, record, p), static_cast<double>(world.graph.separationOf(record, p)), 0, 0};
        if (time > 0) {
            out.normalForce = static_cast<double>(memory[p].totalNormal) / time;
            out.frictionForce = static_cast<double>(memory[p].totalTangent) / time;
        }
        contact.points.push_back(out);
    }
    return contact;
}

}  // namespace

BodyId BodyView::id() const {
    return world_->idOf(index_);
}

BodyType BodyView::type() const {
    return world_->bodies.record[index_].type;
}

Vec2 BodyView::position() const {
    return world_->bodies.origin(index_);
}

double BodyView::angle() const {
    return world_->bodies.motion[index_].angle;
}

Transform BodyView::pose() const {
    return world_->bodies.pose(index_);
}

Vec2 BodyView::centerOfMass() const {
    return world_->bodies.motion[index_].center;
}

Vec2 BodyView::velocity() const {
    return world_->bodies.motion[index_].velocity;
}

double BodyView::angularVelocity() const {
    return world_->bodies.motion[index_].angularVelocity;
}

double BodyView::mass() const {
    return world_->bodies.record[index_].mass;
}

double BodyView::inertia() const {
    return world_->bodies.record[index_].inertia;
}

bool BodyView::awake() const {
    return world_->bodies.record[index_].awake;
}

bool BodyView::quarantined() const {
    return world_->bodies.record[index_].quarantined;
}

std::vector<Contact> BodyView::contacts() const {
    std::vector<Contact> contacts;
    forEachContact(world_->bodies, world_->contacts, index_, [&](ContactIndex index) {
        const ContactRecord& record = world_->contacts.contacts[index];
        if (record.touching) contacts.push_back(contactOf(*world_, record));
    });
    return contacts;
}

void Body::setVelocity(const Vec2& velocity) {
    requireFinite(velocity, "Body.setVelocity: velocity");
    requireMovable(*world_, index_, "Body.setVelocity");
    world_->bodies.motion[index_].velocity = velocity;
    velocityChanged(*world_, index_);
}

void Body::setAngularVelocity(double angularVelocity) {
    requireFinite(angularVelocity, "Body.setAngularVelocity: angularVelocity");
    requireMovable(*world_, index_, "Body.setAngularVelocity");
    if (world_->bodies.record[index_].fixedRotation && angularVelocity != 0)
        refuse("Body.setAngularVelocity: angularVelocity",
               toText(angularVelocity) + " on a body of fixed rotation, not 0");
    world_->bodies.motion[index_].angularVelocity = angularVelocity;
    velocityChanged(*world_, index_);
}

void Body::setPose(const Vec2& position, double angle) {
    requireFinite(position, "Body.setPose: position");
    requireFinite(angle, "Body.setPose: angle");
    wakeNeighbours(*world_, index_);
    BodyMotion& motion = world_->bodies.motion[index_];
    motion.angle = angle;
    motion.rotation = Rot::fromAngle(angle);
    motion.center = position + motion.rotation * world_->bodies.record[index_].localCenter;
    // It has left whatever it was near; the space is to look anew, also at what sleeps where it has come to.
    forEachContact(world_->bodies, world_->contacts, index_, [this](ContactIndex c) { removeContact(*world_, c); });
    world_->bodies.rest(index_);
    placeBody(*world_, index_, 0);
    for (const ProxyId proxy : world_->bodies.record[index_].proxies) world_->space.renew(proxy);
    wakeIsland(*world_, index_);
}

void Body::applyForce(const Vec2& force) {
    applyForce(force, centerOfMass());
}

void Body::applyForce(const Vec2& force, const Vec2& at) {
    requireFinite(force, "Body.applyForce: force");
    requireFinite(at, "Body.applyForce: at");
    addForce(*world_, index_, force, cross(Vec2(at - centerOfMass()), force));
}

void Body::applyTorque(double torque) {
    requireFinite(torque, "Body.applyTorque: torque");
    addForce(*world_, index_, {0, 0}, torque);
}

void Body::applyImpulse(const Vec2& impulse) {
    applyImpulse(impulse, centerOfMass());
}

void Body::applyImpulse(const Vec2& impulse, const Vec2& at) {
    requireFinite(impulse, "Body.applyImpulse: impulse");
    requireFinite(at, "Body.applyImpulse: at");
    const BodyRecord& record = world_->bodies.record[index_];
    BodyMotion& motion = world_->bodies.motion[index_];
    const Vec2 velocity = motion.velocity + impulse * record.inverseMass;
    const double turn =
        record.inverseInertia > 0 ? cross(Vec2(at - motion.center), impulse) * record.inverseInertia : 0.0;
    requireFinite(velocity, "Body.applyImpulse: impulse, for the velocity it would give");
    requireFinite(turn, "Body.applyImpulse: impulse, for the angular velocity it would give");
    motion.velocity = velocity;
    motion.angularVelocity += turn;
    wakeIsland(*world_, index_);
}

}  // namespace plumb
