// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/overlaps.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/solver/contact_pass.h>

namespace plumb {

namespace {

/// Contacts push out less overlap than this themselves [m].
constexpr float deep = 0.01f;
/// Overlap goes at this rate [1/s], and at most this share of it in a step [-].
constexpr double rate = 8, mostShare = 0.2;
/// The farthest that a point of a body moves in a step, as a share of its inradius [-].
constexpr double shareOfInradius = 0.25;
constexpr int sweeps = 12;

/// Contacts of one colour, as shifts see them: without impulses, friction, and the overlap that their loads explain.
struct Shifting {
    std::vector<ContactBatch> batches;
    std::size_t contacts;
    bool oneByOne;
};

/// How far the load of a point presses it in [m].
float pressedBy(const PointLanes& p, std::size_t lane, const ContactPass& pass) {
    if (p.normalMass[lane] == 0) return 0;
    return pass.give * p.normalImpulse[lane] / (p.normalMass[lane] * pass.soft.biasRate);
}

float overlapOf(const PointLanes& p, std::size_t lane, const ContactPass& pass) {
    const float s = p.separation[lane];
    return s < -deep ? std::max(-s - deep - pressedBy(p, lane, pass), 0.0f) : 0.0f;
}

bool someOverlap(const Colour& colour, const ContactPass& pass) {
    for (const ContactBatch& batch : colour.batches)
        for (const PointLanes& p : batch.points) {
            if (*std::min_element(std::begin(p.separation), std::end(p.separation)) >= -deep) continue;
            for (std::size_t lane = 0; lane < batchLanes; ++lane)
                if (overlapOf(p, lane, pass) > 0) return true;
        }
    return false;
}

ContactBatch withoutImpulses(const ContactBatch& batch, const ContactPass& pass) {
    ContactBatch shifting = batch;
    shifting.hasSurfaceSpeed = shifting.hasRollingResistance = false;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        shifting.friction[lane] = 0;
        for (PointLanes& p : shifting.points) {
            p.separation[lane] = std::max(p.separation[lane], 0.0f) - overlapOf(p, lane, pass);
            p.normalImpulse[lane] = p.tangentImpulse[lane] = 0;
        }
    }
    return shifting;
}

bool someOverlap(const ContactGraph& graph, const ContactPasses& passes) {
    for (std::size_t i = 0; i < graph.colours.size(); ++i)
        if (someOverlap(graph.colours[i], passes.of(i))) return true;
    return false;
}

std::vector<Shifting> shiftingOf(const ContactGraph& graph, const ContactPasses& passes) {
    std::vector<Shifting> all;
    for (std::size_t i = 0; i < graph.colours.size(); ++i) {
        const Colour& colour = graph.colours[i];
        Shifting one{{}, colour.contactOf.size(), colourAt(i) == overflowColour};
        for (const ContactBatch& batch : colour.batches) one.batches.push_back(withoutImpulses(batch, passes.of(i)));
        all.push_back(std::move(one));
    }
    return all;
}

/// The shift of each body per second.
std::vector<SolverVelocity> shiftsOf(std::vector<Shifting> shifting, const BodyStore& bodies,
                                     const SolverSettings& settings, double dt) {
    std::vector<SolverVelocity> shifts(bodies.velocity.size());
    for (std::size_t body = 0; body < shifts.size(); ++body)
        shifts[body].inverseMass = bodies.velocity[body].inverseMass;
    SolverBodies moved;
    moved.velocity = shifts.data();
    ContactPass pass;
    pass.inverseStep = static_cast<float>(1 / dt);
    pass.soft.biasRate = static_cast<float>(std::min(rate, mostShare / dt));
    pass.pushSpeed = static_cast<float>(settings.contactPushSpeed);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (Shifting& one : shifting)
            contactSolver(one.oneByOne ? 1 : settings.lanes).solve(one.batches.data(), one.contacts, moved, pass);
    return shifts;
}

void shift(BodyStore& bodies, BodyIndex body, const SolverVelocity& by, double dt) {
    const BodyRecord& record = bodies.record[body];
    const Vec2 way = Vec2(static_cast<double>(by.x), static_cast<double>(by.y)) * dt;
    const double turn = static_cast<double>(by.w * bodies.turn[body].inverseGyration) * dt;
    const double far = way.norm() + std::fabs(turn) * record.turningRadius;
    const double share = std::min(1.0, shareOfInradius * record.inradius / far);
    BodyMotion motion = bodies.motion[body];
    motion.center += way * share;
    motion.angle += turn * share;
    motion.rotation = Rot::fromAngle(motion.angle);
    storeMotion(bodies, body, motion);
    bodies.record[body].stillTime = 0;
}

}  // namespace

void pushApart(const ContactGraph& graph, BodyStore& bodies, const SolverSettings& settings, double dt) {
    const ContactPasses passes = passesOf(settings, dt / settings.subSteps);
    if (!someOverlap(graph, passes)) return;
    const std::vector<SolverVelocity> shifts = shiftsOf(shiftingOf(graph, passes), bodies, settings, dt);
    for (const BodyIndex body : bodies.awake) {
        const SolverVelocity& by = shifts[body];
        if (by.x != 0 || by.y != 0 || by.w != 0) shift(bodies, body, by, dt);
    }
}

}  // namespace plumb
