// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/joint_system.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/joint_bodies.h>
#include <plumb/dynamics/detail/joint_impacts.h>
#include <plumb/dynamics/detail/joints_edit.h>

namespace plumb {

namespace {

/// Nets of joints that are swept are held this stiffly, as a share of the sub-step rate, so that their give falls with
/// the step. Those that are solved at once close their whole gaps in one sub-step, which is truer; what one sweep does
/// not solve blows up on that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 2;

NetPass passOf(const SolverSettings& settings, const JointHalf& half) {
    const double h = half.step, pull = settings.contactPushSpeed;
    const float step = static_cast<float>(h), fastest = static_cast<float>(pull);
    const HingeSolver* hinges = &hingeSolver(settings.lanes);
    if (!half.correct) return {{h, false, 0, pull}, {h, false, 0, pull}, {step, false, fastest, {}}, hinges};
    const Softness soft = softness(jointFrequencyShare / h, jointDampingRatio, h);
    return {{h, true, 1 / h, pull},
            {h, true, static_cast<double>(soft.biasRate), pull},
            {step, true, fastest, soft},
            hinges};
}

/// What sleeps bears what it did; a joint that holds nothing any more bears nothing, and one whose body has left the
/// range of numbers has no first guess.
void forgetLoads(WorldState& world) {
    for (JointIndex index = 0; index < world.joints.records.size(); ++index) {
        JointRecord& record = world.joints[index];
        if (!record.acts()) continue;
        if (!holdsSomething(world.joints, world.bodies, index)) world.joints.loads[index] = {};
        for (double& impulse : record.impulse) impulse = std::isfinite(impulse) ? impulse : 0;
    }
}

void findAwakeNets(WorldState& world) {
    if (!world.jointsChanged) return;
    world.jointsChanged = false;
    const std::vector<JointNet> before = std::move(world.nets);
    for (const JointNet& net : before) net.hinges.release(world.joints);
    forgetLoads(world);
    world.nets = findNets(world.joints, world.bodies, world.def.solver.jointsAtOnce);
    keepStiffness(before, world.nets);
    world.awakeJoints.clear();
    for (const JointNet& net : world.nets)
        world.awakeJoints.insert(world.awakeJoints.end(), net.joints.begin(), net.joints.end());
    std::sort(world.awakeJoints.begin(), world.awakeJoints.end());
    const auto only = [&world](auto&& test) {
        std::vector<JointIndex> some;
        std::copy_if(world.awakeJoints.begin(), world.awakeJoints.end(), std::back_inserter(some), test);
        return some;
    };
    world.breakable = only([&world](JointIndex index) { return world.joints[index].mayBreak(); });
    world.springs.find(world.awakeJoints, world.joints);
}

void prepareJoints(WorldState& world, double dt) {
    findAwakeNets(world);
    for (const JointIndex index : world.awakeJoints) {
        world.joints.loads[index] = {};
        world.joints.loads[index].time = dt;
    }
    for (JointNet& net : world.nets) net.hinges.prepare(hingeSolver(world.def.solver.lanes), world.bodies);
    world.springs.share(world.joints, world.bodies, dt / world.def.solver.subSteps);
}

Vec2 momentumOf(const WorldState& world, const std::vector<BodyIndex>& bodies) {
    Vec2 sum(0, 0);
    for (const BodyIndex body : bodies) {
        const SolverVelocity& v = world.bodies.velocity[body];
        sum += world.bodies.record[body].mass * Vec2(static_cast<double>(v.x), static_cast<double>(v.y));
    }
    return sum;
}

Audit* auditOf(WorldState& world) {
    return world.audit ? &*world.audit : nullptr;
}

void solveJoints(WorldState& world, const JointHalf& half) {
    NetPass pass = passOf(world.def.solver, half);
    pass.audit = auditOf(world);
    for (JointNet& net : world.nets) {
        const Vec2 before = pass.audit != nullptr ? momentumOf(world, net.bodies) : Vec2(0, 0);
        solveNet(net, world.joints, world.bodies, pass);
        if (pass.audit != nullptr) pass.audit->noteGround(momentumOf(world, net.bodies) - before);
    }
}

/// The joints have the last word before bodies move: a blow on a plank of a bridge is a blow on the bridge. What they
/// take out is not what the contacts have done, and so not in their next first guess.
void holdAgain(WorldState& world, double h) {
    const JointPass pass{h, true, 1 / h, world.def.solver.contactPushSpeed};
    BodyStore& bodies = world.bodies;
    for (JointNet& net : world.nets) {
        const auto touched = [&](BodyIndex body) { return bodies.record[body].solverContacts > 0; };
        if (!net.direct || std::none_of(net.bodies.begin(), net.bodies.end(), touched)) continue;
        std::vector<SolverVelocity> was;
        for (const BodyIndex body : net.bodies) was.push_back(bodies.velocity[body]);
        const Vec2 momentum = world.audit ? momentumOf(world, net.bodies) : Vec2(0, 0);
        holdNet(net, world.joints, bodies, pass, auditOf(world));
        if (world.audit) world.audit->noteGround(momentumOf(world, net.bodies) - momentum);
        for (std::size_t i = 0; i < net.bodies.size(); ++i) {
            const SolverVelocity& now = bodies.velocity[net.bodies[i]];
            SolverVelocity& before = bodies.before[net.bodies[i]];
            before.x += now.x - was[i].x;
            before.y += now.y - was[i].y;
            before.w += now.w - was[i].w;
        }
    }
}

void bounceWhatHangs(WorldState& world, const std::vector<ContactIndex>& contacts, const std::vector<BodyIndex>& solved,
                     double h) {
    if (contacts.empty()) return;
    const Vec2 before = world.audit ? momentumOf(world, solved) : Vec2(0, 0);
    bounceHanging(world, contacts, h);
    if (world.audit) world.audit->noteGround(momentumOf(world, solved) - before);
}

void noteSpeeds(WorldState& world, double h) {
    world.springs.noteSpeeds(world.joints, world.bodies, h);
}

/// A body was put elsewhere.
void followMove(WorldState& world, BodyIndex body) {
    moveLocks(world, body);
    joinNearest(world, body);
}

void tellLoads(WorldState& world) {
    for (const JointNet& net : world.nets) net.hinges.tellLoads(world.joints);
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
    return load.mostForce * (stretch - 0.5 * load.mostForce / stiffness);  // one that pulls no harder
}

double springEnergy(const WorldState& world) {
    double energy = 0;
    const auto sound = [&](BodyIndex body) { return isSound(world.bodies.motion[body]); };
    for (JointIndex joint = 0; joint < world.joints.records.size(); ++joint)
        if (world.joints.hasSpring(joint) && sound(world.joints[joint].bodyA) && sound(world.joints[joint].bodyB))
            energy += springEnergyOf(world.joints.springLoadOf(joint, world.bodies));
    return energy;
}

}  // namespace

const JointSystem jointSystem{.prepare = prepareJoints,
                              .noteSpeeds = noteSpeeds,
                              .solve = solveJoints,
                              .takeBounces = takeHangingBounces,
                              .bounce = bounceWhatHangs,
                              .hold = holdAgain,
                              .tellLoads = tellLoads,
                              .breakOverloaded = breakJoints,
                              .springEnergy = springEnergy,
                              .lock = lockBody,
                              .followMove = followMove,
                              .shiftAnchors = shiftAnchors,
                              .removeAllOf = removeJointsOf};

}  // namespace plumb
