// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/solver.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/body_solver.h>
#include <plumb/dynamics/detail/contact_solver.h>
#include <plumb/dynamics/detail/field_solving.h>
#include <plumb/dynamics/detail/joint_system.h>
#include <plumb/dynamics/detail/lanes.h>

namespace plumb {

namespace {

struct Pass {
    ContactPass contacts, groundContacts;
};

Pass passOf(const SolverSettings& settings, double h) {
    Pass pass;
    const auto contactPass = [&](double frequency) -> ContactPass {
        return {static_cast<float>(1 / h), softness(std::min(frequency, 0.25 / h), settings.contactDampingRatio, h),
                static_cast<float>(settings.contactPushSpeed)};
    };
    pass.contacts = contactPass(settings.contactFrequency);
    pass.groundContacts = contactPass(2 * settings.contactFrequency);
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

/// What all of the solver's phases need.
struct Solving {
    WorldState& world;
    double step;  ///< of the sub-step [s]
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

void solveHalf(Solving& solving, JointHalf half, bool first) {
    WorldState& world = solving.world;
    const std::uint32_t* list = solving.solved.data();
    if (world.jointSystem != nullptr && half.correct) world.jointSystem->noteSpeeds(world, half.step);
    if (world.audit) world.audit->beforeKick(world, solving.solved);
    kickBodies(list, solving.solved.size(), solving.bodies, first);
    solving.fields.kick(solving.solved);
    if (world.awakeJoints.empty()) return;
    world.jointSystem->solve(world, half);
    world.jointSystem->bounce(world, solving.bounces, solving.solved, half.step);
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

void subStep(Solving& solving, bool first) {
    solveHalf(solving, {solving.step, true}, first);
    solveContacts(solving, &ContactSolver::solve);
    if (solving.world.jointSystem != nullptr) solving.world.jointSystem->hold(solving.world, solving.step);
    if (solving.world.audit) solving.world.audit->endHalf(solving.world);
    solving.mover.move(solving.solved.data(), solving.solved.size(), solving.bodies, static_cast<float>(solving.step));
    solving.fields.moved();
    solveHalf(solving, {solving.step, false}, false);
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
                    h,
                    world.bodies.solverBodies(),
                    contactSolver(lanes),
                    bodySolver(lanes),
                    solvedBodies(world),
                    passOf(world.def.solver, h),
                    FieldSolving(world, h),
                    {}};
    const JointSystem* joints = world.jointSystem;
    if (joints != nullptr) joints->prepare(world, dt);
    if (solving.solved.empty()) return;
    if (joints != nullptr) solving.bounces = joints->takeBounces(world);
    if (world.audit) world.audit->begin(world);
    forEachColour(solving, [&](const ContactSolver& solver, const Colour& colour, const ContactPass&) {
        solver.gatherWarmStart(colour.batches.data(), colour.batches.size(), solving.bodies);
    });
    for (int i = 0; i < subSteps; ++i) subStep(solving, i == 0);
    bounceContacts(solving);
    if (joints != nullptr) joints->tellLoads(world);
    markPushed(world);
    storeBodies(solving);
    if (world.audit) world.audit->end(world, solving.solved, dt);
}

}  // namespace plumb
