// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_springs.h>

#include <cmath>

#include <plumb/dynamics/joints/joint_measure.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

constexpr double mostF = 1.8;
constexpr double lastPhase = 1.4706289056333368;  ///< 4 sin^2(lastPhase / 2) = mostF [rad]

/// F(q) / q.
double shareOf(double q) {
    if (q < 1e-12) return 1;
    const double phase = std::sqrt(q);
    if (phase >= lastPhase) return mostF / q;
    const double s = 2 * sinCos(0.5 * phase).sin;
    return s * s / q;
}

/// The part of one end in the row's effective inverse mass [1/kg].
double effectiveInverseMass(const BodyStore& bodies, BodyIndex body, const Vec3& at) {
    const BodyRecord& record = bodies.record[body];
    return record.inverseMass * (at[0] * at[0] + at[1] * at[1]) + record.inverseInertia * at[2] * at[2];
}

}  // namespace

void JointSprings::find(const std::vector<JointIndex>& joints, const JointStore& store) {
    joints_.clear();
    for (const JointIndex joint : joints)
        if (store.hasSpring(joint)) joints_.push_back({joint, store.formOf(joint)});
}

void JointSprings::share(JointStore& store, const BodyStore& bodies, double h) {
    if (joints_.empty()) return;
    load_.resize(bodies.record.size(), 0.0);
    for (const auto& [joint, form] : joints_)
        for (const BodyIndex body : {store[joint].bodyA, store[joint].bodyB}) load_[body] = 0;
    for (const auto& [joint, form] : joints_) {
        const SpringLoad load = springLoadOf(form, bodies);
        const std::array<BodyIndex, 2> ends{store[joint].bodyA, store[joint].bodyB};
        for (std::size_t r = 0; r < load.count; ++r)
            for (std::size_t e = 0; e < 2; ++e)
                load_[ends[e]] += load.row[r].stiffness * effectiveInverseMass(bodies, ends[e], load.row[r].at[e]);
    }
    for (const auto& [joint, form] : joints_)
        store[joint].springShare = shareOf(h * h * (load_[store[joint].bodyA] + load_[store[joint].bodyB]));
}

}  // namespace plumb
