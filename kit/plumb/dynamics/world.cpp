// SPDX-License-Identifier: MIT
#include <plumb/dynamics/world.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include <plumb/dynamics/detail/continuous.h>
#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/joints_edit.h>
#include <plumb/dynamics/detail/load_bodies.h>
#include <plumb/dynamics/detail/narrow_phase.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/quarantine.h>
#include <plumb/dynamics/detail/report_contacts.h>
#include <plumb/dynamics/detail/shape_measure.h>
#include <plumb/dynamics/detail/solver.h>
#include <plumb/dynamics/detail/sort_out.h>
#include <plumb/dynamics/detail/validate.h>
#include <plumb/math/check.h>
#include <plumb/shapes/chain.h>

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
    world.quarantines.clear();
    world.ends.erase(world.ends.begin(), world.ends.begin() + static_cast<std::ptrdiff_t>(world.reportedEnds));
}

/// In less than this nothing that presses or pulls could make a difference, and 1/dt might leave the solver's floats
/// [s].
constexpr double shortestSolved = 1e-9;

void flyFreeBodies(WorldState& world, double dt) {
    for (const BodyIndex body : world.bodies.awake) {
        const BodyRecord& record = world.bodies.record[body];
        if (world.bodies.pushed[body] != 0 || record.flown) continue;
        moveTo(world, body, fly(world.bodies.motion[body], flightLawOf(record, world.def.gravity), dt));
    }
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

double extentOf(const Convex& convex) {
    float farthest = 0;
    for (int i = 0; i < convex.count; ++i)
        farthest = std::max(farthest, convex.vertices[static_cast<std::size_t>(i)].norm());
    return static_cast<double>(farthest + convex.radius);
}

void addShape(WorldState& world, BodyIndex body, const ShapeDef& shape, std::uint32_t number) {
    BodyRecord& record = world.bodies.record[body];
    const Aabb box = aabbOf(shape.shape, world.bodies.pose(body));
    const bool fixed = record.type == BodyType::Static;
    const ProxyId proxy = world.space.add(shape, body, fixed, record.localCenter, box, number);
    record.proxies.push_back(proxy);
    if (record.type != BodyType::Dynamic) ++world.walls;
    record.extent = std::max(record.extent, extentOf(world.space[proxy].convex));
    record.reach = std::max(record.reach, reachOf(shape.shape, record.localCenter));
    record.core = std::min(record.core, coreOf(shape.shape));
    std::vector<BoxOutline>& boxes = world.contacts.boxes;
    if (boxes.size() <= proxy) boxes.resize(proxy + std::size_t{1});
    boxes[proxy] = boxOutlineOf(shape, record.localCenter);
}

void addShapes(WorldState& world, BodyIndex body, const BodyDef& def) {
    for (const ShapeDef& shape : def.shapes) {
        const std::uint32_t number = world.bodies.record[body].shapesMade++;
        for (const Shape& piece : piecesOf(shape.shape)) {
            ShapeDef part = shape;
            part.shape = piece;
            addShape(world, body, part, number);
        }
    }
}

}  // namespace

World::World(const WorldDef& def) {
    validate(def);
    state_ = std::make_unique<WorldState>();
    state_->def = def;
    state_->id = nextWorldId();
    state_->collider = &laneCollider(def.solver.lanes);
    state_->space.setLanes(def.solver.lanes);
}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

BodyId World::add(const BodyDef& def) {
    validate(def, "BodyDef");
    BodyStore& bodies = state_->bodies;
    const BodyIndex body = bodies.acquire();
    BodyRecord& record = bodies.record[body];
    record.type = def.type;
    if (def.type == BodyType::Kinematic) bodies.kinematic.push_back(body);
    record.alive = true;
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
    if (def.type == BodyType::Dynamic) lockBody(*state_, body, def.lockX, def.lockY);
    return state_->idOf(body);
}

void World::remove(BodyId id) {
    requireBody(*state_, id, "BodyId");
    WorldState& world = *state_;
    wakeNeighbours(world, id.index);
    removeJointsOf(world, id.index);
    removeShapes(world, id.index);
    world.bodies.release(id.index);
}

void World::step(double dt) {
    requireNotNegative(dt, "World.step: dt");
    WorldState& world = *state_;
    clearEvents(world);
    world.legs.clear();
    if (dt > 0) {
        Stopwatch watch(world.profile);
        world.lastStep = dt;
        loadBodies(world, dt);
        quarantine(world);
        if (dt >= shortestSolved) {
            findPairs(world);
            watch.lap(&StepProfile::pairs);
            findContacts(world, dt);
            watch.lap(&StepProfile::collide);
            sortOutContacts(world, dt);
            watch.lap(&StepProfile::impacts);
            solveConstraints(world, dt);
            watch.lap(&StepProfile::solve);
        }
        flyFreeBodies(world, dt);
        stopAtWalls(world, dt);
        breakJoints(world);
        reportContacts(world);
        clearForces(world.bodies);
        quarantine(world);
        sleepIslands(world, dt);
        watch.lap(&StepProfile::finish);
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

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body)
        if (state_->bodies.record[body].alive) ids.push_back(state_->idOf(body));
    return ids;
}

Vec2 World::gravity() const {
    return state_->def.gravity;
}

void World::setGravity(const Vec2& gravity) {
    requireFinite(gravity, "World.setGravity: gravity");
    state_->def.gravity = gravity;
    for (BodyIndex body = 1; body < state_->bodies.record.size(); ++body) wakeIsland(*state_, body);
}

std::span<const ContactBegin> World::contactBegins() const {
    return state_->begins;
}

std::span<const ContactEnd> World::contactEnds() const {
    return {state_->ends.data(), state_->reportedEnds};
}

std::span<const Quarantined> World::quarantines() const {
    return state_->quarantines;
}

StepProfile World::profile() const {
    return state_->profile;
}

}  // namespace plumb
