// SPDX-License-Identifier: MIT
#include <plumb/dynamics/world.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <utility>

#include <plumb/dynamics/detail/body_shapes.h>
#include <plumb/dynamics/detail/continuous.h>
#include <plumb/dynamics/detail/field_flight.h>
#include <plumb/dynamics/detail/field_pull.h>
#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/load_bodies.h>
#include <plumb/dynamics/detail/narrow_phase.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/quarantine.h>
#include <plumb/dynamics/detail/report_contacts.h>
#include <plumb/dynamics/detail/sensors.h>
#include <plumb/dynamics/detail/solver.h>
#include <plumb/dynamics/detail/sort_out.h>
#include <plumb/dynamics/detail/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// The one count that worlds share: by it an id of another world is told from one of this.
std::uint32_t nextWorldId() {
    static std::atomic<std::uint32_t> count{0};
    return ++count;
}

void clearEvents(WorldState& world) {
    world.begins.clear();
    world.breaks.clear();
    world.hits.clear();
    world.sensors.begins.clear();
    world.sensors.ends.clear();
    world.quarantines.clear();
    world.ends.erase(world.ends.begin(), world.ends.begin() + static_cast<std::ptrdiff_t>(world.reportedEnds));
}

/// In less than this nothing that presses or pulls could make a difference, and 1/dt might leave the solver's floats
/// [s].
constexpr double shortestSolved = 1e-9;

/// A phase is over: what it did to the energy.
void book(WorldState& world, double EnergyLedger::*entry) {
    if (world.audit) world.audit->book(world, entry, &MomentumLedger::solver);
}

void flyFreeBodies(WorldState& world, double dt) {
    for (const BodyIndex body : world.bodies.awake) {
        const BodyRecord& record = world.bodies.record[body];
        if (world.bodies.pushed[body] != 0) continue;
        if (record.flown) continue;
        const BodyMotion from = world.bodies.motion[body];
        moveTo(world, body, fly(from, flightLawOf(world, body), dt));
        if (world.audit) world.audit->noteFlight(world, body, from, world.bodies.motion[body], dt);
        finishFlight(world, body);
    }
    book(world, &EnergyLedger::solver);
}

void clearForces(BodyStore& bodies) {
    for (const BodyIndex body : bodies.forced) {
        bodies.record[body].force.setZero();
        bodies.record[body].torque = 0;
    }
    bodies.forced.clear();
}

/// Notes how long each phase takes. Nothing else depends on it.
class Stopwatch {
public:
    explicit Stopwatch(StepProfile& profile) : profile_(profile), last_(Clock::now()) { profile_ = {}; }
    void lap(double StepProfile::*phase) {
        const Clock::time_point now = Clock::now();
        profile_.*phase = std::chrono::duration<double>(now - last_).count();
        profile_.total += profile_.*phase;
        last_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    StepProfile& profile_;
    Clock::time_point last_;
};

void addShapes(WorldState& world, BodyIndex body, const BodyDef& def) {
    for (const ShapeDef& shape : def.shapes) addShape(world, body, shape, world.bodies.record[body].shapesMade++);
}

/// What was awake in the step; the rest of what moves() tells is looked up when it is asked for.
void noteMovers(WorldState& world) {
    world.movers = world.bodies.awake;
    world.sleepers.clear();
    world.gone.clear();
}

}  // namespace

World::World(const WorldDef& def) {
    validate(def);
    auto state = std::make_unique<WorldState>();
    state->def = def;
    state->id = nextWorldId();
    state->collider = &laneCollider(def.solver.lanes);
    state->space.setLanes(def.solver.lanes);
    state->space.setWrap(def.wrap);
    state->bodies.wrap = def.wrap;
    if (def.ledger) state->audit.emplace();
    state_ = state.release();
}

World::World(const World& other) : state_(std::make_unique<WorldState>(*other.state_).release()) {}
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
    if (const JointSystem* joints = def.lockX.joints() ? def.lockX.joints() : def.lockY.joints())
        joints->lock(*state_, body, def.lockX, def.lockY);
    if (!def.awake) bodies.putToSleep(body);
    return state_->idOf(body);
}

void World::remove(BodyId id) {
    requireBody(*state_, id, "BodyId");
    WorldState& world = *state_;
    wakeNeighbours(world, id.index);
    wakeWhatItDraws(world, id.index);
    if (world.jointSystem != nullptr) world.jointSystem->removeAllOf(world, id.index);
    removeShapes(world, id.index);
    world.parkedMass.erase(id.index);
    world.gone.push_back(id.index);
    std::erase(world.unsound, id.index);
    world.bodies.release(id.index);
}

void World::step(double dt) {
    requireNotNegative(dt, "World.step: dt");
    WorldState& world = *state_;
    clearEvents(world);
    world.legs.clear();
    if (world.audit) world.audit->book(world, &EnergyLedger::edits, &MomentumLedger::edits);
    if (dt > 0) {
        Stopwatch watch(world.profile);
        world.lastStep = dt;
        foretellFlights(world, dt);
        loadBodies(world, dt);
        quarantine(world);
        book(world, &EnergyLedger::solver);
        if (dt >= shortestSolved) {
            findPairs(world);
            watch.lap(&StepProfile::pairs);
            findContacts(world, dt);
            watch.lap(&StepProfile::collide);
            sortOutContacts(world, dt);
            book(world, &EnergyLedger::impacts);
            watch.lap(&StepProfile::impacts);
            solveConstraints(world, dt);
            book(world, &EnergyLedger::solver);
            watch.lap(&StepProfile::solve);
        }
        flyFreeBodies(world, dt);
        stopAtWalls(world, dt);
        book(world, &EnergyLedger::solver);
        if (world.jointSystem != nullptr) world.jointSystem->breakOverloaded(world);
        book(world, &EnergyLedger::breaking);
        reportContacts(world);
        clearForces(world.bodies);
        quarantine(world);
        if (dt >= shortestSolved) watchSensors(world, dt);
        noteMovers(world);
        sleepIslands(world, dt);
        book(world, &EnergyLedger::solver);
        forgetFlights(world);
        watch.lap(&StepProfile::finish);
    } else {
        noteMovers(world);
    }
    world.reportedEnds = world.ends.size();
}

bool World::contains(BodyId id) const {
    return isKnown(*state_, id);
}

Body World::body(BodyId id) {
    requireBody(*state_, id, "BodyId");
    return {*state_, id.index};
}

BodyView World::body(BodyId id) const {
    requireBody(*state_, id, "BodyId");
    return {*state_, id.index};
}

Ledger World::ledger() const {
    if (!state_->audit) refuse("World.ledger", "WorldDef.ledger was not set, so no account was kept");
    Audit now = *state_->audit;
    now.book(*state_, &EnergyLedger::edits, &MomentumLedger::edits);
    return now.ledger();
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body)
        if (state_->bodies.record[body].alive) ids.push_back(state_->idOf(body));
    return ids;
}

const Wrap& World::wrap() const {
    return state_->def.wrap;
}

Vec2 World::gravity() const {
    return state_->def.gravity;
}

void World::setGravity(const Vec2& gravity) {
    requireFinite(gravity, "World.setGravity: gravity");
    state_->def.gravity = gravity;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body) wakeIsland(*state_, body);
}

StepProfile World::profile() const {
    return state_->profile;
}

}  // namespace plumb
