// SPDX-License-Identifier: MIT
#include <plumb/dynamics/world.h>

#include <atomic>
#include <memory>
#include <utility>

#include <plumb/dynamics/edit/body_shapes.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// The only counter that worlds share: it makes the ids of different worlds different.
std::uint32_t nextWorldId() {
    static std::atomic<std::uint32_t> count{0};
    return ++count;
}

void addShapes(WorldState& world, BodyIndex body, const BodyDef& def) {
    for (const ShapeDef& shape : def.shapes) addShape(world, body, shape, world.bodies.record[body].shapesMade++);
}

}  // namespace

/// The state is behind a pointer, so that a user's program includes none of the rooms.
World::World(const WorldDef& def) {
    validate(def);
    auto state = std::make_unique<WorldState>();
    state->sleeping = def.sleeping;
    state->hitSpeed = def.hitSpeed;
    state->solver = def.solver;
    state->space.setLanes(def.solver.lanes);
    state->space.setWrap(def.wrap);
    state->bodies.world = nextWorldId();
    state->bodies.wrap = def.wrap;
    state->bodies.gravity = def.gravity;
    state->bodies.subSteps = def.solver.subSteps;
    if (def.ledger) state->account.emplace();
    state_ = state.release();
}

World::World(const World& other) : state_(new WorldState(*other.state_)) {}
World& World::operator=(const World& other) {
    return *this = World(other);
}
World::World(World&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
World& World::operator=(World&& other) noexcept {
    delete std::exchange(state_, std::exchange(other.state_, nullptr));
    return *this;
}
World::~World() {
    delete state_;
}

BodyId World::add(const BodyDef& def) {
    validate(def, "BodyDef");
    requireFit(*state_, def);
    BodyStore& bodies = state_->bodies;
    const BodyIndex body = bodies.acquire();
    BodyRecord& record = bodies.record[body];
    record.type = def.type;
    if (def.type == BodyType::Kinematic) bodies.kinematic.push_back(body);
    record.alive = true;
    record.enabled = def.enabled;
    record.tag = def.tag;
    record.massGiven = def.mass.has_value();
    record.canSleep = def.canSleep;
    record.fixedRotation = def.fixedRotation;
    record.gravityScale = def.gravityScale;
    record.linearDamping = def.linearDamping;
    record.angularDamping = def.angularDamping;
    if (def.type == BodyType::Dynamic) setMass(record, massOf(def));
    BodyMotion& motion = bodies.motion[body];
    motion.angle = def.angle;
    motion.rotation = Rot::fromAngle(def.angle);
    motion.center = def.position + motion.rotation * record.localCenter;
    motion.velocity = def.velocity;
    motion.angularVelocity = def.angularVelocity;
    addShapes(*state_, body, def);
    bodies.rest(body);
    const bool moves = def.type == BodyType::Dynamic || !def.velocity.isZero(0) || def.angularVelocity != 0;
    if (moves && def.awake) bodies.wake(body);
    // The lock itself brings the code of joints along: a program without locks and joints links none of it (lock.h).
    if (const JointSolver* solver = def.lockX ? def.lockX.solver() : def.lockY.solver())
        lockBody(*state_, body, def.lockX, def.lockY, *solver);
    // Last, because a lock wakes its body.
    if (!def.awake) bodies.putToSleep(body);
    return bodies.idOf(body);
}

/// In this order: neighbours are found by contacts and joints, so they wake first; a joint needs both of its bodies
/// while it is removed; the slot is free only when nothing refers to it.
void World::remove(BodyId id) {
    requireBody(*state_, id, "BodyId");
    WorldState& world = *state_;
    wakeNeighbours(world, id.index);
    wakeInfluencedByMagnetsOn(world, id.index);
    removeJointsOf(world, id.index);
    removeShapes(world, id.index);
    world.parkedMass.erase(id.index);
    world.events.gone.push_back(id.index);
    world.bodies.release(id.index);
}

bool World::contains(BodyId id) const {
    return isKnown(*state_, id);
}

Body World::body(BodyId id) {
    requireBody(*state_, id, "BodyId");
    return {*state_, id};
}

BodyView World::body(BodyId id) const {
    requireBody(*state_, id, "BodyId");
    return {*state_, id};
}

/// What calls have changed since the last step is closed in a copy, so that asking does not change the account.
Ledger World::ledger() const {
    const WorldState& w = *state_;
    if (!w.account) refuse("World.ledger", "WorldDef.ledger was not set, so no account was kept");
    Account now = *w.account;
    now.close({w.bodies, w.fields, w.graph, w.joints, w.space, *w.jointSolver}, &EnergyLedger::edits,
              &MomentumLedger::edits);
    return now.ledger();
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body)
        if (state_->bodies.record[body].alive) ids.push_back(state_->bodies.idOf(body));
    return ids;
}

const Wrap& World::wrap() const {
    return state_->bodies.wrap;
}

Vec2 World::gravity() const {
    return state_->bodies.gravity;
}

/// What rests is in balance with the gravity of before, so everything wakes. O(bodies).
void World::setGravity(const Vec2& gravity) {
    requireFinite(gravity, "World.setGravity: gravity");
    state_->bodies.gravity = gravity;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body) wakeIsland(*state_, body);
}

StepProfile World::profile() const {
    return state_->profile;
}

}  // namespace plumb
