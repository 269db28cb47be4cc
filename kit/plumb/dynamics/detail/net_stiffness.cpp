// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/net_stiffness.h>

#include <algorithm>

namespace plumb {

namespace {

/// A line's stiffness is forgotten in so long [s].
constexpr double memory = 2;

/// What does not move weighs a million times what hangs on it.
double weightOf(const std::vector<Vec3>& masses, std::uint32_t node, const Vec2& arm, double hanging) {
    if (node == JointNet::Seats::fixed) return 1e6 * hanging;
    const double turning = masses[node][2] > 0 ? arm.squaredNorm() / masses[node][2] : 0.0;
    return 1 / (1 / masses[node][0] + turning);
}

/// For each body, the least by which its neighbours, each free but for it, add to its inertia when it turns:
/// sum m' r^2 - |sum m' r|^2 / (m + sum m'), m' what a neighbour weighs at the anchor at r, whichever way.
std::vector<double> companyOf(const JointNet& net) {
    struct Company {
        double mass = 0, squares = 0;
        Vec2 moment{0, 0};
    };
    const std::vector<Vec3>& masses = net.work.masses;
    std::vector<Company> company(masses.size());
    for (std::size_t j = 0; j < net.work.rows.size(); ++j) {
        const JointRows& rows = net.work.rows[j];
        if (!rows.holdsPoint) continue;
        const auto& nodes = net.seats[j].node;
        for (std::size_t e = 0; e < 2; ++e) {
            if (nodes[e] == JointNet::Seats::fixed) continue;
            const double weight = weightOf(masses, nodes[1 - e], rows.arm[1 - e], masses[nodes[e]][0]);
            Company& c = company[nodes[e]];
            c.mass += weight;
            c.moment += weight * rows.arm[e];
            c.squares += weight * rows.arm[e].squaredNorm();
        }
    }
    std::vector<double> added(masses.size());
    for (std::size_t b = 0; b < added.size(); ++b)
        added[b] = company[b].squares - company[b].moment.squaredNorm() / (masses[b][0] + company[b].mass);
    return added;
}

/// Of each body, by the forces of this pass alone.
void findFresh(JointNet& net, double h) {
    const double rate = 2 / h;  // impulses are of half a sub-step
    std::fill(net.stiffness.begin(), net.stiffness.end(), Vec3{});
    for (std::size_t j = 0; j < net.work.rows.size(); ++j) {
        const JointRows& rows = net.work.rows[j];
        for (std::size_t e = 0; e < 2; ++e) {
            const std::uint32_t node = net.seats[j].node[e];
            if (node == JointNet::Seats::fixed) continue;
            Vec2 force(0, 0);
            for (std::size_t r = 0; r < rows.count; ++r)
                force += Vec2(rows.row[r].at[e][0], rows.row[r].at[e][1]) * (net.work.impulses[j][r] * rate);
            net.stiffness[node][2] += force.dot(rows.arm[e]);
            if (!(rows.length > 0)) continue;
            const double aside = 2 * force.norm() / rows.length;
            net.stiffness[node][0] += aside;
            net.stiffness[node][1] += aside;
        }
    }
}

void slowTurning(const JointNet& net, BodyStore& bodies, double h) {
    const auto needed = [&](std::size_t b) { return 2 * net.stiffness[b][2] * h * h; };
    bool tight = false;
    for (std::size_t b = 0; b < net.bodies.size(); ++b)
        tight = tight || needed(b) > bodies.record[net.bodies[b]].inertia;
    const std::vector<double> company = tight ? companyOf(net) : std::vector<double>();
    for (std::size_t b = 0; b < net.bodies.size(); ++b) {
        BodyRecord& record = bodies.record[net.bodies[b]];
        const double alone = tight ? needed(b) - company[b] : 0.0;
        if (record.inverseInertia > 0) setRho(record, 1 / std::max(record.inertia, alone));
    }
}

}  // namespace

void findMasses(JointNet& net, const BodyStore& bodies, double h) {
    net.work.masses.resize(net.bodies.size());
    for (std::size_t b = 0; b < net.bodies.size(); ++b) {
        const double mass = 1 / static_cast<double>(bodies.velocity[net.bodies[b]].inverseMass);
        const double rho = static_cast<double>(bodies.turn[net.bodies[b]].rho);
        const double linear = std::max({mass, net.stiffness[b][0] * (h * h), net.stiffness[b][1] * (h * h)});
        net.work.masses[b] = {linear, linear, rho > 0 ? mass / (rho * rho) : 0.0};
    }
}

void noteStiffness(JointNet& net, BodyStore& bodies, double h) {
    // It falls slowly: one that follows the forces' every turn pumps up what swings (tried).
    net.work.stiffnessBefore = net.stiffness;
    findFresh(net, h);
    const double kept = 1 - std::min(0.5 * h / memory, 1.0);
    for (std::size_t b = 0; b < net.bodies.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i)
            net.stiffness[b][i] = std::max(net.stiffness[b][i], kept * net.work.stiffnessBefore[b][i]);
    slowTurning(net, bodies, h);
}

}  // namespace plumb
