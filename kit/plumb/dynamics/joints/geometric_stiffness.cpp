// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/geometric_stiffness.h>

#include <algorithm>

namespace plumb {

namespace {

/// Time in which the stiffness of a line that is no longer tight decays [s].
constexpr double memory = 2;

/// The least effective mass, over all directions, of a neighbour at its anchor. A fixed one counts as a million times
/// the body's own mass.
double leastEffectiveMass(const std::vector<Vec3>& masses, std::uint32_t node, const Vec2& arm, double ownMass) {
    if (node == JointIsland::EndNodes::fixed) return 1e6 * ownMass;
    const double turning = masses[node][2] > 0 ? arm.squaredNorm() / masses[node][2] : 0.0;
    return 1 / (1 / masses[node][0] + turning);
}

/// For each body, the least inertia that its neighbours add when it turns, each neighbour taken as connected to this
/// body only: sum m' r^2 - |sum m' r|^2 / (m + sum m'), m' the least effective mass, over all directions, of a
/// neighbour at the anchor at r.
std::vector<double> neighbourInertiaOf(const JointIsland& island) {
    struct NeighbourMass {
        double mass = 0, squares = 0;
        Vec2 moment{0, 0};
    };
    const std::vector<Vec3>& masses = island.work.masses;
    std::vector<NeighbourMass> neighbours(masses.size());
    for (std::size_t j = 0; j < island.work.rows.size(); ++j) {
        const JointRows& rows = island.work.rows[j];
        if (!rows.holdsPoint) continue;
        const auto& nodes = island.endNodes[j].node;
        for (std::size_t e = 0; e < 2; ++e) {
            if (nodes[e] == JointIsland::EndNodes::fixed) continue;
            const double weight = leastEffectiveMass(masses, nodes[1 - e], rows.arm[1 - e], masses[nodes[e]][0]);
            NeighbourMass& c = neighbours[nodes[e]];
            c.mass += weight;
            c.moment += weight * rows.arm[e];
            c.squares += weight * rows.arm[e].squaredNorm();
        }
    }
    std::vector<double> added(masses.size());
    for (std::size_t b = 0; b < added.size(); ++b)
        added[b] = neighbours[b].squares - neighbours[b].moment.squaredNorm() / (masses[b][0] + neighbours[b].mass);
    return added;
}

/// The stiffness of each body from the forces of this pass alone.
void findFresh(JointIsland& island, double h) {
    const double rate = 2 / h;  // impulses are of half a sub-step
    std::fill(island.stiffness.begin(), island.stiffness.end(), Vec3{});
    for (std::size_t j = 0; j < island.work.rows.size(); ++j) {
        const JointRows& rows = island.work.rows[j];
        for (std::size_t e = 0; e < 2; ++e) {
            const std::uint32_t node = island.endNodes[j].node[e];
            if (node == JointIsland::EndNodes::fixed) continue;
            Vec2 force(0, 0);
            for (std::size_t r = 0; r < rows.count; ++r)
                force += Vec2(rows.row[r].at[e][0], rows.row[r].at[e][1]) * (island.work.impulses[j][r] * rate);
            island.stiffness[node][2] += force.dot(rows.arm[e]);
            if (!(rows.length > 0)) continue;
            const double aside = 2 * force.norm() / rows.length;
            island.stiffness[node][0] += aside;
            island.stiffness[node][1] += aside;
        }
    }
}

void slowTurning(const JointIsland& island, BodyStore& bodies, double h) {
    const auto needed = [&](std::size_t b) { return 2 * island.stiffness[b][2] * h * h; };
    bool tight = false;
    for (std::size_t b = 0; b < island.bodies.size(); ++b)
        tight = tight || needed(b) > bodies.record[island.bodies[b]].inertia;
    const std::vector<double> neighbours = tight ? neighbourInertiaOf(island) : std::vector<double>();
    for (std::size_t b = 0; b < island.bodies.size(); ++b) {
        BodyRecord& record = bodies.record[island.bodies[b]];
        const double alone = tight ? needed(b) - neighbours[b] : 0.0;
        if (record.inverseInertia > 0) setGyration(record, 1 / std::max(record.inertia, alone));
    }
}

}  // namespace

void findMasses(JointIsland& island, const BodyStore& bodies, double h) {
    island.work.masses.resize(island.bodies.size());
    for (std::size_t b = 0; b < island.bodies.size(); ++b) {
        const double mass = 1 / static_cast<double>(bodies.velocity[island.bodies[b]].inverseMass);
        const double inverseGyration = static_cast<double>(bodies.turn[island.bodies[b]].inverseGyration);
        const double linear = std::max({mass, island.stiffness[b][0] * (h * h), island.stiffness[b][1] * (h * h)});
        island.work.masses[b] = {linear, linear,
                                 inverseGyration > 0 ? mass / (inverseGyration * inverseGyration) : 0.0};
    }
}

void noteStiffness(JointIsland& island, BodyStore& bodies, double h) {
    // The stiffness falls slowly: one that follows every change of the forces makes oscillations grow (tried).
    island.work.stiffnessBefore = island.stiffness;
    findFresh(island, h);
    const double kept = 1 - std::min(0.5 * h / memory, 1.0);
    for (std::size_t b = 0; b < island.bodies.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i)
            island.stiffness[b][i] = std::max(island.stiffness[b][i], kept * island.work.stiffnessBefore[b][i]);
    slowTurning(island, bodies, h);
}

}  // namespace plumb
