// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/initial_impulses.h>

#include <plumb/dynamics/contacts/lanes/contact_solver.h>

namespace plumb {

namespace {

/// Number of sweeps over the points of a single contact; each sweep leaves a quarter of the error [-].
constexpr int sweeps = 8;

/// Points with a separation up to this carry load [m].
constexpr float loadedSeparation = 1e-4f;

SolverVelocity kickOf(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    const float share = 1 / static_cast<float>(bodies.subSteps);
    return {place.pullX * share, place.pullY * share, 0, bodies.velocity[body].inverseMass};
}

bool isNew(const ContactBatch& batch, std::size_t lane) {
    for (const PointLanes& p : batch.points)
        if (p.normalImpulse[lane] != 0 || p.tangentImpulse[lane] != 0) return false;
    return true;
}

/// A copy of the batch in which no two lanes share a body. Points that carry no load have zero effective mass.
ContactBatch withBodiesApart(const ContactBatch& batch) {
    ContactBatch own = batch;
    for (std::uint32_t lane = 0; lane < batchLanes; ++lane) {
        own.bodyA[lane] = 2 * lane;
        own.bodyB[lane] = 2 * lane + 1;
        for (PointLanes& p : own.points) {
            if (p.separation[lane] > loadedSeparation) p.normalMass[lane] = p.tangentMass[lane] = 0;
            p.separation[lane] = 0;
        }
    }
    return own;
}

}  // namespace

void guessImpulses(ContactBatch& batch, const BodyStore& bodies, int lanes) {
    SolverVelocity velocity[2 * batchLanes];
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        velocity[2 * lane] = kickOf(bodies, batch.bodyA[lane]);
        velocity[2 * lane + 1] = kickOf(bodies, batch.bodyB[lane]);
    }
    ContactBatch own = withBodiesApart(batch);
    SolverBodies alone;
    alone.velocity = velocity;
    const ContactPass rigid{0, {0, 1, 0}, 0};
    for (int i = 0; i < sweeps; ++i) contactSolver(lanes).solve(&own, batchLanes, alone, rigid);
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        if (!isNew(batch, lane)) continue;
        for (std::size_t p = 0; p < 2; ++p) {
            batch.points[p].normalImpulse[lane] = own.points[p].normalImpulse[lane];
            batch.points[p].tangentImpulse[lane] = own.points[p].tangentImpulse[lane];
        }
    }
}

}  // namespace plumb
