// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/solver.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/contact_solver.h>
#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/prepare_contacts.h>

namespace plumb {

namespace {

/// Joints that share a body are held this stiffly, as a share of the sub-step rate, so that their give falls with the
/// step. A joint alone on its bodies closes its whole gap in one sub-step, which is truer; a grid of joints, which one
/// sweep does not solve, blows up on that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 2;

struct Pass {
    float step = 0;
    ContactPass contacts, groundContacts;
    JointPass solveJoints, relaxJoints;
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
    const Softness rigid{static_cast<float>(1 / h), 1, 0};
    const float pull = static_cast<float>(settings.contactPushSpeed);
    pass.solveJoints = {pass.step, true, pull, rigid, softness(jointFrequencyShare / h, jointDampingRatio, h)};
    pass.relaxJoints = {pass.step, false, pull, {}, {}};
    return pass;
}

/// The bodies that are solved: dynamic ones with a constraint, and kinematic ones, which their contacts must see move.
std::vector<BodyIndex> loadBodies(WorldState& world, double h) {
    std::vector<BodyIndex> solved;
    BodyStore& bodies = world.bodies;
    for (const BodyIndex body : bodies.awake) {
        const BodyRecord& record = bodies.record[body];
        if (!record.constrained && record.type != BodyType::Kinematic) continue;
        solved.push_back(body);
        const BodyMotion& motion = bodies.motion[body];
        bodies.velocity[body] = {static_cast<float>(motion.velocity.x()), static_cast<float>(motion.velocity.y()),
                                 static_cast<float>(motion.angularVelocity) * record.inverseRho,
                                 static_cast<float>(record.inverseMass)};
        bodies.displacement[body] = {};
        bodies.warm[body] = {};
        bodies.turn[body] = 0;
        const FlightLaw law = flightLawOf(record, world.def.gravity);
        const Decay linear = decay(law.linearDamping, 0.5 * h);
        const Decay angular = decay(law.angularDamping, 0.5 * h);
        const Vec2 gain = law.acceleration.linear * linear.gain;
        bodies.kick[body] = {static_cast<float>(gain.x()), static_cast<float>(gain.y()),
                             static_cast<float>(law.acceleration.angular * angular.gain) * record.inverseRho,
                             static_cast<float>(linear.keep), static_cast<float>(angular.keep)};
    }
    return solved;
}

/// What the contacts changed since last time is what they will be given next time, before they are solved again.
void collectWarmStart(BodyStore& bodies, BodyIndex body) {
    SolverVelocity& warm = bodies.warm[body];
    const SolverVelocity& now = bodies.velocity[body];
    const SolverVelocity& before = bodies.before[body];
    warm.x += now.x - before.x;
    warm.y += now.y - before.y;
    warm.w += now.w - before.w;
}

void kick(BodyStore& bodies, BodyIndex body) {
    SolverVelocity& v = bodies.velocity[body];
    if (v.inverseMass == 0) return;
    const Kick& k = bodies.kick[body];
    const SolverVelocity& warm = bodies.warm[body];
    v.x = v.x * k.keep + k.gainX + warm.x;
    v.y = v.y * k.keep + k.gainY + warm.y;
    v.w = v.w * k.keepW + k.gainW + warm.w;
}

struct SinCosMinus1 {
    float sin, cosMinus1;
};

/// Of an angle turned within a step, mostly small: five terms are exact to float below half a radian.
SinCosMinus1 turned(float angle) {
    if (std::fabs(angle) > 0.5f) {
        const SinCos sc = sinCos(static_cast<double>(angle));
        return {static_cast<float>(sc.sin), static_cast<float>(sc.cos - 1)};
    }
    const float a2 = angle * angle;
    const float sin = angle * (1 - a2 * (1.0f / 6 - a2 * (1.0f / 120 - a2 / 5040)));
    const float cosMinus1 = -a2 * (0.5f - a2 * (1.0f / 24 - a2 * (1.0f / 720 - a2 / 40320)));
    return {sin, cosMinus1};
}

void move(BodyStore& bodies, BodyIndex body, float h) {
    const SolverVelocity& v = bodies.velocity[body];
    const BodyRecord& record = bodies.record[body];
    SolverDisplacement& d = bodies.displacement[body];
    d.x += v.x * h;
    d.y += v.y * h;
    bodies.turn[body] += v.w * record.rho * h;
    const SinCosMinus1 t = turned(bodies.turn[body]);
    d.sin = t.sin * record.inverseRho;
    d.cosMinus1 = t.cosMinus1 * record.inverseRho;
}

template <class Visit>
void forEachJoint(WorldState& world, Visit&& visit) {
    for (JointRecord& record : world.joints) {
        if (std::holds_alternative<std::monostate>(record.joint)) continue;
        if (!world.bodies.record[record.bodyA].awake && !world.bodies.record[record.bodyB].awake) continue;
        std::visit(
            [&]<class Joint>(Joint& joint) {
                if constexpr (!std::is_same_v<Joint, std::monostate>) visit(joint, record);
            },
            record.joint);
    }
}

bool isAlone(const BodyStore& bodies, const JointRecord& joint) {
    const auto single = [&bodies](BodyIndex body) {
        return !bodies.isDynamic(body) || bodies.record[body].joints.size() == 1;
    };
    return single(joint.bodyA) && single(joint.bodyB);
}

void solveJoints(WorldState& world, const JointPass& pass) {
    forEachJoint(world, [&](auto& joint, const JointRecord&) { joint.warmStart(world.bodies); });
    forEachJoint(world, [&](auto& joint, const JointRecord&) { joint.solve(world.bodies, pass); });
}

/// What stands on something fixed stands twice as stiffly: the ground does not give.
template <class Visit>
void forEachColour(WorldState& world, const Pass& pass, Visit&& visit) {
    for (int c = 0; c < colourCount; ++c) {
        const bool ground = c >= fixedColour && c != overflowColour;
        visit(world.graph.colours[static_cast<std::size_t>(c)], ground ? pass.groundContacts : pass.contacts);
    }
}

void subStep(WorldState& world, const std::vector<BodyIndex>& solved, const Pass& pass, bool first) {
    BodyStore& bodies = world.bodies;
    for (const BodyIndex body : solved) {
        if (!first) collectWarmStart(bodies, body);
        kick(bodies, body);
    }
    solveJoints(world, pass.solveJoints);
    for (const BodyIndex body : solved) bodies.before[body] = bodies.velocity[body];
    forEachColour(world, pass, [&](Colour& colour, const ContactPass& p) { solveContacts(colour.batches, bodies, p); });
    for (const BodyIndex body : solved) {
        move(bodies, body, pass.step);
        collectWarmStart(bodies, body);
        kick(bodies, body);
    }
    solveJoints(world, pass.relaxJoints);
    for (const BodyIndex body : solved) bodies.before[body] = bodies.velocity[body];
    forEachColour(world, pass, [&](Colour& colour, const ContactPass& p) { relaxContacts(colour.batches, bodies, p); });
}

void markPushed(WorldState& world) {
    const auto markOne = [&world](BodyIndex body) { world.bodies.record[body].pushed = world.bodies.isDynamic(body); };
    for (const Colour& colour : world.graph.colours) {
        for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot) {
            const ContactBatch& batch = colour.batches[slot / batchLanes];
            const std::size_t lane = slot % batchLanes;
            const auto gave = [lane](const PointLanes& p) {  // what only parts an overlap gives nothing in all
                return p.totalNormal[lane] != 0 || p.solvedNormal[lane] != 0;
            };
            if (!gave(batch.points[0]) && !gave(batch.points[1])) continue;
            markOne(batch.bodyA[lane]);
            markOne(batch.bodyB[lane]);
        }
    }
    for (const JointRecord& joint : world.joints) {
        if (std::holds_alternative<std::monostate>(joint.joint)) continue;
        markOne(joint.bodyA);
        markOne(joint.bodyB);
    }
}

void storeBodies(WorldState& world, const std::vector<BodyIndex>& solved) {
    BodyStore& bodies = world.bodies;
    for (const BodyIndex body : solved) {
        const BodyRecord& record = bodies.record[body];
        if (!record.pushed) continue;
        BodyMotion motion = bodies.motion[body];
        const SolverVelocity& v = bodies.velocity[body];
        const SolverDisplacement& d = bodies.displacement[body];
        motion.center += Vec2(static_cast<double>(d.x), static_cast<double>(d.y));
        motion.velocity = {static_cast<double>(v.x), static_cast<double>(v.y)};
        motion.angularVelocity = static_cast<double>(v.w * record.rho);
        if (bodies.turn[body] != 0) {
            motion.angle += static_cast<double>(bodies.turn[body]);
            motion.rotation = Rot::fromAngle(motion.angle);
        }
        moveTo(world, body, motion);
    }
}

}  // namespace

void solveConstraints(WorldState& world, double dt) {
    const int subSteps = world.def.solver.subSteps;
    const double h = dt / subSteps;
    const std::vector<BodyIndex> solved = loadBodies(world, h);
    if (solved.empty()) return;
    const Pass pass = passOf(world.def.solver, h);
    prepareContacts(world, dt);
    forEachJoint(world, [&world, dt](auto& joint, JointRecord& record) {
        record.solvedStep = dt;
        joint.prepare(world.bodies, isAlone(world.bodies, record));
    });
    for (Colour& colour : world.graph.colours) gatherWarmStart(colour.batches, world.bodies);
    for (int i = 0; i < subSteps; ++i) subStep(world, solved, pass, i == 0);
    for (Colour& colour : world.graph.colours) bounceContacts(colour.batches, world.bodies);
    markPushed(world);
    storeBodies(world, solved);
}

}  // namespace plumb
