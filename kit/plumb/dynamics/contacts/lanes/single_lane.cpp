// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/lanes/single_lane.h>

#include <plumb/dynamics/contacts/lanes/contact_solver_wide.h>

namespace plumb {

namespace {

using One = WideContacts<1>;

One::Solved solvedOf(const ContactImpulses& from) {
    return {{{from.normal[0], from.normal[1]}}, {{from.tangent[0], from.tangent[1]}}, from.roll};
}

}  // namespace

ContactImpulses impulsesOf(const ContactBatch& batch, std::size_t lane) {
    ContactImpulses now;
    now.roll = batch.hasRollingResistance ? batch.rollImpulse[lane] : 0.0f;
    for (int i = 0; i < 2; ++i) {
        const PointLanes& p = batch.points[i];
        now.normal[i] = p.normalImpulse[lane];
        now.tangent[i] = p.tangentImpulse[lane];
        now.totalNormal[i] = p.totalNormal[lane];
        now.totalTangent[i] = p.totalTangent[lane];
    }
    return now;
}

float separationNow(const ContactBatch& batch, std::size_t point, std::size_t lane,
                    const SolverDisplacement* displacement) {
    const int at = static_cast<int>(lane);
    const PointLanes& p = batch.points[point];
    return One::Pair::of(batch, at, &displacement->x).separation(batch, p, at, LaneArms<1>::of(p, at));
}

/// For contacts of joint islands, which are solved again after their joints have changed (jointed/joint_contacts.cpp).
/// Velocities are again as if the lane had not been solved.
void takeBackLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactImpulses& start) {
    const int at = static_cast<int>(lane);
    One::Contact c = One::load(batch, at, bodies.velocity);
    const One::Solved now = One::impulses(batch, at), before = solvedOf(start);
    One::setNormals(c, batch, at, now.normal, before.normal);
    One::setTangents(c, batch, at, now.tangent, before.tangent);
    if (batch.hasRollingResistance) c.pair.twist(batch, at, before.roll - now.roll);
    batch.rollImpulse[lane] = before.roll;
    c.pair.store(batch, at, &bodies.velocity->x);
}

void solveLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass) {
    One::solveLanes(batch, static_cast<int>(lane), bodies, pass);
}

void relaxLane(ContactBatch& batch, std::size_t lane, const SolverBodies& bodies, const ContactPass& pass,
               const ContactImpulses& solved) {
    const int at = static_cast<int>(lane);
    One::Contact c = One::load(batch, at, bodies.velocity);
    for (int i = 0; i < 2; ++i) {
        batch.points[i].totalNormal[lane] = solved.totalNormal[i];
        batch.points[i].totalTangent[lane] = solved.totalTangent[i];
    }
    One::relaxPoints(c, batch, at, pass, solvedOf(solved), One::each(batch, at, &PointLanes::normalImpulse),
                     One::each(batch, at, &PointLanes::separation));
    c.pair.store(batch, at, &bodies.velocity->x);
}

}  // namespace plumb
