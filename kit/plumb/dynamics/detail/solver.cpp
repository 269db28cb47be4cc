// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/solver.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/body_solver.h>
#include <plumb/dynamics/detail/contact_solver.h>
#include <plumb/dynamics/detail/field_solving.h>
#include <plumb/dynamics/detail/joint_bodies.h>
#include <plumb/dynamics/detail/joint_impacts.h>
#include <plumb/dynamics/detail/lanes.h>

namespace plumb {

namespace {

/// Nets of joints that are swept are held this stiffly, as a share of the sub-step rate, so that their give falls with
/// the step. Those that are solved at once close their whole gaps in one sub-step, which is truer; what one sweep does
/// not solve blows up on that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 2;

struct Pass {
    float step = 0;
    ContactPass contacts, groundContacts;
    NetPass solveJoints, relaxJoints;
};

Pass passOf(const SolverSettings& settings, double h) {
    Pass pass;
    pass.step = static_cast<float>(h);
    const auto contactPass = [&](double frequency) -> ContactPass {
        return {static_cast<float>(1 / h), softness(std::min(frequency, 0.25 / h), settings.contactDampingRatio, h),
                static_cast<float>(settings.contactPushSpeed)};
    };
    pass.contacts = contactPass(settings.contactFrequency);
    pass.groundContacts = contactPass(2 * settings.contactFrequency);
    const Softness soft = softness(jointFrequencyShare / h, jointDampingRatio, h);
    const double pull = settings.contactPushSpeed;
    const HingeSolver& hinges = hingeSolver(settings.lanes);
    const float fastest = static_cast<float>(pull);
    pass.solveJoints = {{h, true, 1 / h, pull},
                        {h, true, static_cast<double>(soft.biasRate), pull},
                        {pass.step, true, fastest, soft},
                        &hinges};
    pass.relaxJoints = {{h, false, 0, pull}, {h, false, 0, pull}, {pass.step, false, fastest, {}}, &hinges};
    return pass;
}

/// The bodies that are solved: dynamic ones with a constraint, and kinematic ones, which their contacts must see move.
/// Filled up with slot 0, which stands still, so that lanes have company.
std::vector<BodyIndex> solvedBodies(WorldState& world) {
    std::vector<BodyIndex> solved;
    solved.reserve(world.bodies.awake.size() + batchLanes);
    for (const BodyIndex body : world.bodies.awake) {
        BodyRecord& record = world.bodies.record[body];
        record.constrained = record.type == BodyType::Dynamic && (record.solverContacts > 0 || record.actingJoints > 0);
        if (record.constrained || record.type == BodyType::Kinematic) solved.push_back(body);
    }
    while (solved.size() % batchLanes != 0) solved.push_back(noBody);
    return solved;
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

void solveJoints(WorldState& world, NetPass pass) {
    pass.audit = auditOf(world);
    for (JointNet& net : world.nets) {
        const Vec2 before = pass.audit != nullptr ? momentumOf(world, net.bodies) : Vec2(0, 0);
        solveNet(net, world.joints, world.bodies, pass);
        if (pass.audit != nullptr) pass.audit->noteGround(momentumOf(world, net.bodies) - before);
    }
}

/// What all of the solver's phases need.
struct Solving {
    WorldState& world;
    SolverBodies bodies;
    const ContactSolver& contacts;
    const BodySolver& mover;
    std::vector<BodyIndex> solved;
    Pass pass;
    FieldSolving fields;
    std::vector<ContactIndex> bounces;  ///< of what hangs on joints
};

/// What stands on something fixed stands twice as stiffly: the ground does not give. Calls solve(solver, colour, pass).
template <class Solve>
void forEachColour(Solving& solving, Solve&& solve) {
    auto& colours = solving.world.graph.colours;
    for (std::size_t index = 0; index < colours.size(); ++index) {
        std::vector<ContactBatch>& batches = colours[index].batches;
        if (batches.empty()) continue;
        const int colour = colourAt(index);
        const bool ground = colour >= fixedColour && colour != overflowColour;
        const ContactSolver& solver = colour == overflowColour ? scalarContactSolver : solving.contacts;
        solve(solver, colours[index], ground ? solving.pass.groundContacts : solving.pass.contacts);
    }
}

void bounceWhatHangs(Solving& solving, double h) {
    WorldState& world = solving.world;
    if (solving.bounces.empty()) return;
    const Vec2 before = world.audit ? momentumOf(world, solving.solved) : Vec2(0, 0);
    bounceHanging(world, solving.bounces, h);
    if (world.audit) world.audit->noteGround(momentumOf(world, solving.solved) - before);
}

void solveHalf(Solving& solving, const NetPass& joints, bool first) {
    WorldState& world = solving.world;
    const std::uint32_t* list = solving.solved.data();
    if (joints.direct.correct) world.springs.noteSpeeds(world.joints, world.bodies, joints.direct.step);
    if (world.audit) world.audit->beforeKick(world, solving.solved);
    kickBodies(list, solving.solved.size(), solving.bodies, first);
    solving.fields.kick(solving.solved);
    if (world.awakeJoints.empty()) return;
    solveJoints(world, joints);
    bounceWhatHangs(solving, joints.direct.step);
    markBodies(list, solving.solved.size(), solving.bodies);
}

/// One way of going over all contacts: a function of ContactSolver.
using ContactWork = void (*ContactSolver::*)(ContactBatch*, std::size_t, const SolverBodies&, const ContactPass&);

void solveContacts(Solving& solving, ContactWork work) {
    forEachColour(solving, [&](const ContactSolver& solver, Colour& colour, const ContactPass& pass) {
        (solver.*work)(colour.batches.data(), colour.batches.size(), solving.bodies, pass);
    });
}

void bounceContacts(Solving& solving) {
    if (solving.world.audit) solving.world.audit->beforeBounces(solving.world);
    forEachColour(solving, [&](const ContactSolver& solver, Colour& colour, const ContactPass&) {
        solver.bounce(colour.batches.data(), colour.batches.size(), solving.bodies);
    });
    if (solving.world.audit) solving.world.audit->afterBounces(solving.world);
}

/// The joints have the last word before bodies move: a blow on a plank of a bridge is a blow on the bridge. What they
/// take out is not what the contacts have done, and so not in their next first guess.
void holdAgain(Solving& solving) {
    WorldState& world = solving.world;
    BodyStore& bodies = world.bodies;
    for (JointNet& net : world.nets) {
        const auto touched = [&](BodyIndex body) { return bodies.record[body].solverContacts > 0; };
        if (!net.direct || std::none_of(net.bodies.begin(), net.bodies.end(), touched)) continue;
        std::vector<SolverVelocity> was;
        for (const BodyIndex body : net.bodies) was.push_back(bodies.velocity[body]);
        const Vec2 momentum = world.audit ? momentumOf(world, net.bodies) : Vec2(0, 0);
        holdNet(net, world.joints, bodies, solving.pass.solveJoints.direct, auditOf(world));
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

void subStep(Solving& solving, bool first) {
    solveHalf(solving, solving.pass.solveJoints, first);
    solveContacts(solving, &ContactSolver::solve);
    holdAgain(solving);
    if (solving.world.audit) solving.world.audit->endHalf(solving.world);
    solving.mover.move(solving.solved.data(), solving.solved.size(), solving.bodies, solving.pass.step);
    solving.fields.moved();
    solveHalf(solving, solving.pass.relaxJoints, false);
    solveContacts(solving, &ContactSolver::relax);
    if (solving.world.audit) solving.world.audit->endHalf(solving.world);
}

void markPushed(WorldState& world) {
    std::uint8_t* pushed = world.bodies.pushed.data();
    for (const Colour& colour : world.graph.colours) {
        for (const ContactBatch& batch : colour.batches) {
            for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                if (batch.pushed[lane] == 0) continue;
                pushed[batch.bodyA[lane]] = pushed[batch.bodyB[lane]] = 1;
            }
        }
    }
    for (const JointNet& net : world.nets)
        for (const BodyIndex body : net.bodies) pushed[body] = 1;
}

/// A rotation turned on by a small angle: by the series in double, which leaves no more than rounding.
Rot turnedOn(const BodyMotion& motion, double turn) {
    if (std::fabs(turn) > 0.1) return Rot::fromAngle(motion.angle);
    const double t2 = turn * turn;
    const double sin = turn * (1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72))));
    const double cos = 1 - t2 / 2 * (1 - t2 / 12 * (1 - t2 / 30 * (1 - t2 / 56 * (1 - t2 / 90))));
    const Rot& r = motion.rotation;
    const double c = r.cos * cos - r.sin * sin;
    const double s = r.sin * cos + r.cos * sin;
    const double stretch = 1.5 - 0.5 * (c * c + s * s);  // back to length 1, to first order
    Rot turned;
    turned.cos = c * stretch;
    turned.sin = s * stretch;
    return turned;
}

/// What joints have made heavier to turn keeps its momentum: else it would be fed.
double slowerBy(const BodyStore& bodies, BodyIndex body) {
    const double rho = static_cast<double>(bodies.record[body].rho), was = static_cast<double>(bodies.turn[body].rho);
    return rho < was ? rho / was * (rho / was) : 1.0;
}

void storeBodies(Solving& solving) {
    BodyStore& bodies = solving.world.bodies;
    for (const BodyIndex body : solving.solved) {
        const SolverVelocity& v = bodies.velocity[body];
        if (v.inverseMass == 0) bodies.pushed[body] = 0;
        if (bodies.pushed[body] == 0) continue;
        BodyMotion motion = bodies.motion[body];
        const SolverDisplacement& d = bodies.displacement[body];
        motion.center += Vec2(static_cast<double>(d.x), static_cast<double>(d.y));
        motion.velocity = {static_cast<double>(v.x), static_cast<double>(v.y)};
        motion.angularVelocity = static_cast<double>(v.w * bodies.turn[body].rho) * slowerBy(bodies, body);
        if (bodies.record[body].rho != bodies.turn[body].rho) renewRho(solving.world, body);
        const double turn = static_cast<double>(bodies.turn[body].angle);
        motion.angle += turn;
        motion.rotation = turnedOn(motion, turn);
        moveTo(solving.world, body, motion);
    }
}

}  // namespace

void solveConstraints(WorldState& world, double dt) {
    const int subSteps = world.def.solver.subSteps;
    const double h = dt / subSteps;
    const int lanes = world.def.solver.lanes;
    world.bodies.rest(noBody);
    Solving solving{world,
                    world.bodies.solverBodies(),
                    contactSolver(lanes),
                    bodySolver(lanes),
                    solvedBodies(world),
                    passOf(world.def.solver, h),
                    FieldSolving(world, h),
                    {}};
    prepareJoints(world, dt);
    if (solving.solved.empty()) return;
    solving.bounces = takeHangingBounces(world);
    if (world.audit) world.audit->begin(world);
    forEachColour(solving, [&](const ContactSolver& solver, const Colour& colour, const ContactPass&) {
        solver.gatherWarmStart(colour.batches.data(), colour.batches.size(), solving.bodies);
    });
    for (int i = 0; i < subSteps; ++i) subStep(solving, i == 0);
    bounceContacts(solving);
    for (const JointNet& net : world.nets) net.hinges.tellLoads(world.joints);
    markPushed(world);
    storeBodies(solving);
    if (world.audit) world.audit->end(world, solving.solved, dt);
}

}  // namespace plumb
