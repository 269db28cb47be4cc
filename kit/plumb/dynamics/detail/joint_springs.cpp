// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/joint_springs.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/trig.h>

namespace plumb {

namespace {

constexpr double mostF = 1.8;

/// F(q) / q.
double shareOf(double q) {
    if (q < 1e-12) return 1;
    const double phase = std::sqrt(q);
    constexpr double last = 1.4706289056333368;  // 4 sin^2(last / 2) = 1.8
    if (phase >= last) return mostF / q;
    const double s = 2 * sinCos(0.5 * phase).sin;
    return s * s / q;
}

/// What a unit impulse along the row does to its rate, as far as one end goes [1/kg].
double shareOf(const BodyStore& bodies, BodyIndex body, const Vec3& at) {
    const double inverseMass = static_cast<double>(bodies.velocity[body].inverseMass);
    const double turn = at[2] * static_cast<double>(bodies.turn[body].rho);
    return inverseMass * (at[0] * at[0] + at[1] * at[1] + turn * turn);
}

double rateOf(const BodyStore& bodies, const SpringRows& springs, const SpringRow& row) {
    double rate = 0;
    for (std::size_t e = 0; e < 2; ++e) {
        const SolverVelocity& v = bodies.velocity[springs.body[e]];
        const double spin = static_cast<double>(v.w) * static_cast<double>(bodies.turn[springs.body[e]].rho);
        rate += row.at[e][0] * static_cast<double>(v.x) + row.at[e][1] * static_cast<double>(v.y) + row.at[e][2] * spin;
    }
    return rate;
}

void give(BodyStore& bodies, const SpringRows& springs, const SpringRow& row, double impulse) {
    for (std::size_t e = 0; e < 2; ++e) {
        SolverVelocity& v = bodies.velocity[springs.body[e]];
        const double m = static_cast<double>(v.inverseMass) * impulse;
        const double rho = static_cast<double>(bodies.turn[springs.body[e]].rho);
        v.x = static_cast<float>(static_cast<double>(v.x) + m * row.at[e][0]);
        v.y = static_cast<float>(static_cast<double>(v.y) + m * row.at[e][1]);
        v.w = static_cast<float>(static_cast<double>(v.w) + m * rho * row.at[e][2]);
    }
}

void addLoad(JointLoad& load, const SpringRows& springs, const SpringRow& row, double impulse) {
    const Vec2 along(row.at[1][0], row.at[1][1]);
    load.impulse += along * impulse;
    load.turning += (row.at[1][2] - cross(springs.armB, along)) * impulse;
}

double compliance(const BodyStore& bodies, const SpringRows& springs, const SpringRow& row) {
    return shareOf(bodies, springs.body[0], row.at[0]) + shareOf(bodies, springs.body[1], row.at[1]);
}

/// What each row's damper takes away.
Vec3 dampings(const BodyStore& bodies, const SpringRows& springs, double half) {
    Vec3 impulses{};
    for (std::size_t r = 0; r < springs.count; ++r) {
        const SpringRow& row = springs.row[r];
        const double w = compliance(bodies, springs, row);
        if (row.spring.damping > 0 && w > 0)
            impulses[r] = exponentialMinus1(-row.spring.damping * w * half) / w * rateOf(bodies, springs, row);
    }
    return impulses;
}

void giveAll(JointLoad& load, BodyStore& bodies, const SpringRows& springs, Vec3 impulses, double most) {
    double squares = 0;
    for (std::size_t r = 0; r < springs.count; ++r) squares += impulses[r] * impulses[r];
    const double size = std::sqrt(squares);
    for (std::size_t r = 0; r < springs.count; ++r) {
        const double impulse = size > most ? impulses[r] * (most / size) : impulses[r];
        give(bodies, springs, springs.row[r], impulse);
        addLoad(load, springs, springs.row[r], impulse);
    }
}

}  // namespace

void JointSprings::find(const std::vector<JointIndex>& joints, const JointStore& store) {
    joints_.clear();
    for (const JointIndex joint : joints)
        if (store.hasSpring(joint)) joints_.push_back(joint);
}

void JointSprings::prepare(const JointStore& store, const BodyStore& bodies) {
    if (joints_.empty()) return;
    load_.resize(bodies.record.size(), 0.0);
    for (const JointIndex joint : joints_)
        for (const BodyIndex body : {store[joint].bodyA, store[joint].bodyB}) load_[body] = 0;
    for (const JointIndex joint : joints_) {
        const SpringRows springs = store.springsOf(joint, bodies);
        for (std::size_t r = 0; r < springs.count; ++r) {
            const SpringRow& row = springs.row[r];
            for (std::size_t e = 0; e < 2; ++e)
                load_[springs.body[e]] += row.spring.stiffness * shareOf(bodies, springs.body[e], row.at[e]);
        }
    }
}

void JointSprings::pull(JointStore& store, BodyStore& bodies, double step, bool dampFirst) {
    const double half = 0.5 * step;
    for (const JointIndex joint : joints_) {
        const SpringRows springs = store.springsOf(joint, bodies);
        JointLoad& load = store.loads[joint];
        const double most = springs.mostForce * half;
        const bool bounded = most < unlimited;
        if (dampFirst && !bounded) giveAll(load, bodies, springs, dampings(bodies, springs, half), most);
        const double share = shareOf(step * step * (load_[springs.body[0]] + load_[springs.body[1]]));
        Vec3 pulls = bounded ? dampings(bodies, springs, half) : Vec3{};  // no more than that together
        for (std::size_t r = 0; r < springs.count; ++r)
            pulls[r] -= springs.row[r].spring.stiffness * share * springs.row[r].stretch * half;
        giveAll(load, bodies, springs, pulls, most);
        if (!dampFirst && !bounded) giveAll(load, bodies, springs, dampings(bodies, springs, half), most);
    }
}

}  // namespace plumb
