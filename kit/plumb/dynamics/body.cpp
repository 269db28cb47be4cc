// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body.h>

#include <plumb/dynamics/edit/body_shapes.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/state/world_state.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// To be called after a body's velocity was changed by an edit: the body must be awake exactly if it moves or can be
/// moved.
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

/// Adds a force over the next step. Each body is noted once only, so repeated calls while a game pauses take no more
/// memory.
void addForce(WorldState& world, BodyIndex body, const Vec2& force, double torque) {
    BodyRecord& record = world.bodies.record[body];
    if (record.force.isZero(0) && record.torque == 0) world.bodies.forced.push_back(body);
    record.force += force;
    record.torque += torque;
    wakeIsland(world, body);
}

template <class Value>
void requireMovable(const WorldState& world, BodyIndex body, const char* field, const Value& value) {
    if (world.bodies.record[body].type == BodyType::Static && value != Value{})
        refuse(field, toText(value) + " to a body that is static, and stays where it is");
}

template <class Value>
void requirePushable(const WorldState& world, BodyIndex body, const char* field, const Value& value) {
    const BodyType type = world.bodies.record[body].type;
    if (type != BodyType::Dynamic)
        refuse(field, toText(value) + " does nothing to a body that is " + nameOf(type) + ", not dynamic");
}

/// A contact as users see it: the mean forces of the last step, from its total impulses over the step's length. A
/// contact that has left the solver keeps those of the step in which it was solved last, and that step's length.
Contact contactOf(const WorldState& world, const ContactRecord& record) {
    const Vec2 normal = normalOf(world.graph, world.bodies, record);
    Contact contact{world.idOfShape(record.proxyA), world.idOfShape(record.proxyB), normal, {}};
    const double time = record.isSolved() ? world.bodies.lastStep : record.memoryStep;
    const auto memory = world.graph.memoryOf(record);
    for (std::size_t p = 0; p < static_cast<std::size_t>(world.graph.manifoldOf(record).count); ++p) {
        const Vec2 where = pointOf(world.graph, world.bodies, record, p);
        const MetTile tile{record.proxyA, record.proxyB, record.shift, where, normal};
        ContactPoint out{.position = world.bodies.wrap.place(where),
                         .separation = static_cast<double>(world.graph.separationOf(record, p)),
                         .tile = tileTouched(world.tiles, world.bodies, world.space, tile)};
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
    return id_;
}

/// Each call of a view checks its id, so a view of a body that was removed throws, and never reads another body.
std::uint32_t BodyView::index() const {
    requireBody(*world_, id_, "BodyId");
    return id_.index;
}

BodyType BodyView::type() const {
    return world_->bodies.record[index()].type;
}

Vec2 BodyView::position() const {
    return world_->bodies.wrap.place(world_->bodies.origin(index()));
}

double BodyView::angle() const {
    return world_->bodies.motion[index()].angle;
}

Transform BodyView::pose() const {
    return {position(), world_->bodies.motion[index()].rotation};
}

Vec2 BodyView::centerOfMass() const {
    return world_->bodies.wrap.place(world_->bodies.motion[index()].center);
}

Vec2 BodyView::velocity() const {
    return world_->bodies.motion[index()].velocity;
}

double BodyView::angularVelocity() const {
    return world_->bodies.motion[index()].angularVelocity;
}

double BodyView::mass() const {
    return world_->bodies.record[index()].mass;
}

double BodyView::inertia() const {
    return world_->bodies.record[index()].inertia;
}

Vec2 BodyView::velocityAt(const Vec2& point) const {
    requireFinite(point, "BodyView.velocityAt: point");
    const BodyMotion& motion = world_->bodies.motion[index()];
    return plumb::velocityAt(motion, world_->bodies.near(point, motion.center));
}

double BodyView::gravityScale() const {
    return world_->bodies.record[index()].gravityScale;
}

double BodyView::linearDamping() const {
    return world_->bodies.record[index()].linearDamping;
}

double BodyView::angularDamping() const {
    return world_->bodies.record[index()].angularDamping;
}

bool BodyView::enabled() const {
    return world_->bodies.record[index()].enabled;
}

std::uint64_t BodyView::tag() const {
    return world_->bodies.record[index()].tag;
}

/// Pieces of one shape stand side by side: each number is listed once.
std::vector<ShapeId> BodyView::shapes() const {
    std::vector<ShapeId> shapes;
    for (const ProxyId proxy : world_->bodies.links[index()].proxies) {
        const std::uint32_t number = world_->space[proxy].number;
        if (shapes.empty() || shapes.back().number != number) shapes.push_back({id(), number});
    }
    return shapes;
}

std::vector<JointId> BodyView::joints() const {
    std::vector<JointId> joints;
    for (const JointIndex joint : world_->bodies.links[index()].joints)
        if (!world_->joints[joint].isHidden())
            joints.push_back({joint, world_->joints[joint].generation, world_->bodies.world});
    return joints;
}

bool BodyView::awake() const {
    return world_->bodies.record[index()].awake;
}

bool BodyView::quarantined() const {
    return world_->bodies.record[index()].quarantined;
}

std::vector<Contact> BodyView::contacts() const {
    std::vector<Contact> contacts;
    forEachContact(world_->bodies, world_->contacts, index(), [&](ContactIndex index) {
        const ContactRecord& record = world_->contacts[index];
        if (record.touching) contacts.push_back(contactOf(*world_, record));
    });
    return contacts;
}

void Body::setVelocity(const Vec2& velocity) {
    requireFinite(velocity, "Body.setVelocity: velocity");
    requireMovable(*world_, index(), "Body.setVelocity: velocity", velocity);
    world_->bodies.motion[index()].velocity = velocity;
    velocityChanged(*world_, index());
}

void Body::setAngularVelocity(double angularVelocity) {
    requireFinite(angularVelocity, "Body.setAngularVelocity: angularVelocity");
    requireMovable(*world_, index(), "Body.setAngularVelocity: angularVelocity", angularVelocity);
    if (world_->bodies.record[index()].fixedRotation && angularVelocity != 0)
        refuse("Body.setAngularVelocity: angularVelocity",
               toText(angularVelocity) + " on a body of fixed rotation, not 0");
    world_->bodies.motion[index()].angularVelocity = angularVelocity;
    velocityChanged(*world_, index());
}

/// A jump: the velocity stays, and nothing between the two places is met. What lay on the body wakes while its contacts
/// still tell what that was; locks and joints follow to the new place.
void Body::setPose(const Vec2& position, double angle) {
    requireFinite(position, "Body.setPose: position");
    requireFinite(angle, "Body.setPose: angle");
    for (const ProxyId proxy : world_->bodies.links[index()].proxies)
        requireFit(*world_, world_->space[proxy].def.shape, {position, Rot::fromAngle(angle)}, "Body.setPose: angle");
    wakeNeighbours(*world_, index());
    BodyMotion& motion = world_->bodies.motion[index()];
    const bool inRange = isInRange(motion);
    motion.angle = angle;
    motion.rotation = Rot::fromAngle(angle);
    const Vec2 center = position + motion.rotation * world_->bodies.record[index()].localCenter;
    motion.center = world_->bodies.near(world_->bodies.wrap.place(center), motion.center);
    // The body has left its neighbours; the space must find its pairs again, also with sleeping bodies at the new
    // position.
    world_->bodies.rest(index());
    findPairsAgain(*world_, index());
    followMove(*world_, index());
    world_->joints.changed = world_->joints.changed || isInRange(motion) != inRange;
    wakeIsland(*world_, index());
}

void Body::applyForce(const Vec2& force) {
    applyForce(force, world_->bodies.motion[index()].center);
}

void Body::applyForce(const Vec2& force, const Vec2& at) {
    requireFinite(force, "Body.applyForce: force");
    requireFinite(at, "Body.applyForce: at");
    requirePushable(*world_, index(), "Body.applyForce: force", force);
    const Vec2& center = world_->bodies.motion[index()].center;
    addForce(*world_, index(), force, cross(Vec2(world_->bodies.near(at, center) - center), force));
}

void Body::applyTorque(double torque) {
    requireFinite(torque, "Body.applyTorque: torque");
    requirePushable(*world_, index(), "Body.applyTorque: torque", torque);
    addForce(*world_, index(), {0, 0}, torque);
}

void Body::applyImpulse(const Vec2& impulse) {
    applyImpulse(impulse, world_->bodies.motion[index()].center);
}

/// Checked by its result: a finite impulse may make a velocity that is not finite, of a light body.
void Body::applyImpulse(const Vec2& impulse, const Vec2& at) {
    requireFinite(impulse, "Body.applyImpulse: impulse");
    requireFinite(at, "Body.applyImpulse: at");
    requirePushable(*world_, index(), "Body.applyImpulse: impulse", impulse);
    const BodyRecord& record = world_->bodies.record[index()];
    BodyMotion& motion = world_->bodies.motion[index()];
    const Vec2 velocity = motion.velocity + impulse * record.inverseMass;
    const Vec2 arm = world_->bodies.near(at, motion.center) - motion.center;
    const double turn = record.inverseInertia > 0 ? cross(arm, impulse) * record.inverseInertia : 0.0;
    requireFinite(velocity, "Body.applyImpulse: impulse, for the velocity it would give");
    requireFinite(turn, "Body.applyImpulse: impulse, for the angular velocity it would give");
    motion.velocity = velocity;
    motion.angularVelocity += turn;
    wakeIsland(*world_, index());
}

void Body::applyAngularImpulse(double impulse) {
    requireFinite(impulse, "Body.applyAngularImpulse: impulse");
    requirePushable(*world_, index(), "Body.applyAngularImpulse: impulse", impulse);
    const double inverse = world_->bodies.record[index()].inverseInertia;
    const double turn = inverse > 0 ? impulse * inverse : 0.0;
    requireFinite(turn, "Body.applyAngularImpulse: impulse, for the angular velocity it would give");
    world_->bodies.motion[index()].angularVelocity += turn;
    wakeIsland(*world_, index());
}

/// Sets the velocity that leads there in one step, in place of a jump, so that contacts feel the motion and carry
/// bodies along.
void Body::moveTo(const Vec2& position, double angle, double dt) {
    requireFinite(position, "Body.moveTo: position");
    requireFinite(angle, "Body.moveTo: angle");
    requirePositive(dt, "Body.moveTo: dt");
    const BodyRecord& record = world_->bodies.record[index()];
    if (record.type != BodyType::Kinematic)
        refuse("Body.moveTo", "the body is not kinematic, but " + nameOf(record.type));
    BodyMotion& motion = world_->bodies.motion[index()];
    const Vec2 target = world_->bodies.near(position + Rot::fromAngle(angle) * record.localCenter, motion.center);
    const Vec2 velocity = (target - motion.center) / dt;
    const double turn = (angle - motion.angle) / dt;
    requireFinite(velocity, "Body.moveTo: position, for the velocity it takes");
    requireFinite(turn, "Body.moveTo: angle, for the angular velocity it takes");
    if (record.fixedRotation && turn != 0)
        refuse("Body.moveTo: angle", toText(angle) + " to a body of fixed rotation, not " + toText(motion.angle));
    motion.velocity = velocity;
    motion.angularVelocity = turn;
    velocityChanged(*world_, index());
}

}  // namespace plumb
