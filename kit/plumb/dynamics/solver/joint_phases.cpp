// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/joint_phases.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/find_islands.h>
#include <plumb/dynamics/joints/joint_bodies.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/joints/solve_island.h>
#include <plumb/dynamics/solver/joint_bounces.h>
#include <plumb/dynamics/solver/machine_sweep.h>

namespace plumb {

namespace {

/// The frequency of the joints of swept islands, as a share of the sub-step rate, so that their compliance falls with
/// the step. Islands that are solved directly close their whole gaps in one sub-step, which is more exact; a sweep that
/// leaves errors becomes unstable with that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 2;

IslandPass passOf(const SolverSettings& settings, const JointHalf& half) {
    const double h = half.step, pull = settings.contactPushSpeed;
    const float step = static_cast<float>(h), fastest = static_cast<float>(pull);
    const HingeSolver* hinges = &hingeSolver(settings.lanes);
    const JointPass direct = directPass(settings, half);
    if (!half.correct) return {direct, {h, false, 0, pull}, {step, false, fastest, {}}, hinges};
    const Softness soft = softness(jointFrequencyShare / h, jointDampingRatio, h);
    return {direct, {h, true, static_cast<double>(soft.biasRate), pull}, {step, true, fastest, soft}, hinges};
}

/// A sleeping joint keeps its load. A joint that no longer holds anything gets no load, and one whose body is out of
/// range gets no first guess.
void resetLoads(JointStore& joints, const BodyStore& bodies) {
    for (JointIndex index = 0; index < joints.records.size(); ++index) {
        JointRecord& record = joints[index];
        if (!record.acts()) continue;
        if (!holdsSomething(joints, bodies, index)) joints.loads[index] = {};
        for (double& impulse : record.impulse) impulse = std::isfinite(impulse) ? impulse : 0;
    }
}

void findAwakeIslands(const JointStores& stores) {
    JointStore& joints = stores.joints;
    JointIslands& found = stores.islands;
    if (!joints.changed) return;
    joints.changed = false;
    const std::vector<JointIsland> before = std::move(found.islands);
    for (const JointIsland& island : before) island.hinges.release(joints);
    resetLoads(joints, stores.bodies);
    found.islands = findJointIslands(joints, stores.bodies, stores.settings.jointsAtOnce, found.plans);
    keepStiffness(before, found.islands);
    found.joints.clear();
    for (const JointIsland& island : found.islands)
        found.joints.insert(found.joints.end(), island.joints.begin(), island.joints.end());
    std::sort(found.joints.begin(), found.joints.end());
    found.breakable.clear();
    std::copy_if(found.joints.begin(), found.joints.end(), std::back_inserter(found.breakable),
                 [&joints](JointIndex index) { return joints[index].mayBreak(); });
    found.springs.find(found.joints, joints);
}

void prepareJoints(const JointStores& stores, double dt) {
    findAwakeIslands(stores);
    for (const JointIndex index : stores.islands.joints) {
        stores.joints.loads[index] = {};
        stores.joints.loads[index].time = dt;
    }
    for (JointIsland& island : stores.islands.islands)
        island.hinges.prepare(hingeSolver(stores.settings.lanes), stores.bodies);
    stores.islands.springs.share(stores.joints, stores.bodies, dt / stores.settings.subSteps);
}

Vec2 momentumOf(const BodyStore& bodies, const std::vector<BodyIndex>& some) {
    Vec2 sum(0, 0);
    for (const BodyIndex body : some) {
        const SolverVelocity& v = bodies.velocity[body];
        sum += bodies.record[body].mass * Vec2(static_cast<double>(v.x), static_cast<double>(v.y));
    }
    return sum;
}

/// Calls change(), and reports to the observer how it changed the momentum of some bodies: only fixed bodies can give
/// them momentum.
template <class Change>
void reportGround(const JointStores& stores, const std::vector<BodyIndex>& some, Change&& change) {
    const Vec2 before = stores.observer != nullptr ? momentumOf(stores.bodies, some) : Vec2(0, 0);
    change();
    if (stores.observer != nullptr) stores.observer->noteGround(momentumOf(stores.bodies, some) - before);
}

/// An island that is solved together with its contacts. What it gives is reported when the contacts are known.
void firstTry(JointIsland& island, const JointStores& stores, const JointPass& pass) {
    island.trial.before = velocitiesOf(island, stores.bodies);
    if (pass.correct)
        for (std::size_t b = 0; b < island.bodies.size(); ++b)
            setVelocity(stores.bodies, island.bodies[b], island.trial.after[b]);
    tryIsland(island, stores.joints, stores.bodies, island.trial.before, pass);
    island.trial.after = velocitiesOf(island, stores.bodies);
}

void solveJoints(const JointStores& stores, const JointHalf& half) {
    IslandPass pass = passOf(stores.settings, half);
    pass.observer = stores.observer;
    for (JointIsland& island : stores.islands.islands) {
        if (island.trial.wanted)
            firstTry(island, stores, pass.direct);
        else
            reportGround(stores, island.bodies, [&] { solveIsland(island, stores.joints, stores.bodies, pass); });
    }
}

/// The joints are solved once more before bodies move: an impact on one plank of a bridge then acts on the whole
/// bridge. This correction is not a contact impulse, so it is kept out of the contacts' next first guess.
void holdJoints(const JointStores& stores, double h) {
    const JointPass pass = directPass(stores.settings, {h, true});
    BodyStore& bodies = stores.bodies;
    for (JointIsland& island : stores.islands.islands) {
        const auto touched = [&](BodyIndex body) { return bodies.links[body].solverContacts > 0; };
        if (!island.direct || island.trial.wanted || std::none_of(island.bodies.begin(), island.bodies.end(), touched))
            continue;
        std::vector<SolverVelocity> was;
        for (const BodyIndex body : island.bodies) was.push_back(bodies.velocity[body]);
        reportGround(stores, island.bodies, [&] { holdIsland(island, stores.joints, bodies, pass, stores.observer); });
        for (std::size_t i = 0; i < island.bodies.size(); ++i) {
            const SolverVelocity& now = bodies.velocity[island.bodies[i]];
            SolverVelocity& before = bodies.before[island.bodies[i]];
            before.x += now.x - was[i].x;
            before.y += now.y - was[i].y;
            before.w += now.w - was[i].w;
        }
    }
}

void bounceJointed(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                   const std::vector<BounceGroup>& bounces, const std::vector<BodyIndex>& solved, double h) {
    if (bounces.empty()) return;
    reportGround(stores, solved, [&] { bounceJointedBodies(stores, graph, contacts, bounces, h); });
}

void noteSpeeds(const JointStores& stores, double h) {
    for (JointIsland& island : stores.islands.islands)
        if (island.trial.wanted) island.trial.after = velocitiesOf(island, stores.bodies);
    stores.islands.springs.noteSpeeds(stores.joints, stores.bodies, h);
}

void addLoads(JointStore& joints, const JointIslands& islands) {
    for (const JointIsland& island : islands.islands) island.hinges.addLoads(joints);
}

void pushJointed(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse, double h) {
    reportGround(stores, island.bodies, [&] { pushIsland(island, stores.joints, stores.bodies, body, impulse, h); });
    if (stores.observer != nullptr) stores.observer->noteGround(-Vec2(impulse[0], impulse[1]));
}

void holdOneIsland(const JointStores& stores, JointIsland& island, double h) {
    const JointPass pass = directPass(stores.settings, {h, true});
    reportGround(stores, island.bodies, [&] { holdIsland(island, stores.joints, stores.bodies, pass, nullptr); });
}

Vec3 answerOfJointed(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse, double h) {
    return answerOfIsland(island, stores.joints, stores.bodies, body, impulse, h);
}

double springEnergyOf(const SpringLoad& load) {
    double squares = 0, energy = 0, stiffness = 0;
    for (std::size_t r = 0; r < load.count; ++r) {
        const SpringLoad::Row& row = load.row[r];
        energy += 0.5 * row.stiffness * row.stretch * row.stretch;
        squares += row.stretch * row.stretch;
        stiffness = row.stiffness;
    }
    const double stretch = std::sqrt(squares);
    if (stiffness * stretch <= load.mostForce) return energy;
    return load.mostForce * (stretch - 0.5 * load.mostForce / stiffness);  // its force is limited to mostForce
}

double springEnergy(const JointStore& joints, const BodyStore& bodies) {
    double energy = 0;
    const auto inRange = [&](BodyIndex body) { return isInRange(bodies.motion[body]); };
    for (JointIndex joint = 0; joint < joints.records.size(); ++joint)
        if (joints.hasSpring(joint) && inRange(joints[joint].bodyA) && inRange(joints[joint].bodyB))
            energy += springEnergyOf(joints.springLoadOf(joint, bodies));
    return energy;
}

}  // namespace

const JointPhases jointPhases{.prepare = prepareJoints,
                              .noteSpeeds = noteSpeeds,
                              .solve = solveJoints,
                              .takeBounces = takeJointedBounces,
                              .bounce = bounceJointed,
                              .takeMachines = takeMachineContacts,
                              .hideMachines = hideMachineContacts,
                              .solveMachines = solveMachineContacts,
                              .hold = holdJoints,
                              .push = pushJointed,
                              .answer = answerOfJointed,
                              .holdOne = holdOneIsland,
                              .addLoads = addLoads,
                              .springEnergy = springEnergy};

}  // namespace plumb
