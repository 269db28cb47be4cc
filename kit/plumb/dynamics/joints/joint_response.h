// SPDX-License-Identifier: MIT
// How does an impulse in a joint change the velocities of its bodies?
#pragma once
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The change of the body's velocity (x, y, turn) by an impulse (x, y, turn).
inline Vec3 velocityChangeBy(const BodyStore& bodies, BodyIndex body, const Vec3& impulse) {
    const double inverseMass = static_cast<double>(bodies.velocity[body].inverseMass);
    const double inverseGyration = static_cast<double>(bodies.turn[body].inverseGyration);
    return {inverseMass * impulse[0], inverseMass * impulse[1],
            inverseMass * inverseGyration * inverseGyration * impulse[2]};
}

inline double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 times(const Vec3& v, double factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

inline void add(Vec3& to, const Vec3& v) {
    for (std::size_t i = 0; i < 3; ++i) to[i] += v[i];
}

inline Vec3 velocityOf(const BodyStore& bodies, BodyIndex body) {
    const SolverVelocity& v = bodies.velocity[body];
    const double spin = static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration);
    return {static_cast<double>(v.x), static_cast<double>(v.y), spin};
}

inline void setVelocity(BodyStore& bodies, BodyIndex body, const Vec3& velocity) {
    SolverVelocity& v = bodies.velocity[body];
    v.x = static_cast<float>(velocity[0]);
    v.y = static_cast<float>(velocity[1]);
    v.w = static_cast<float>(velocity[2] * static_cast<double>(bodies.turn[body].gyration));
}

inline std::vector<Vec3> velocitiesOf(const JointIsland& island, const BodyStore& bodies) {
    std::vector<Vec3> velocities;
    for (const BodyIndex body : island.bodies) velocities.push_back(velocityOf(bodies, body));
    return velocities;
}

/// The change of a row's speed by a unit of its own impulse.
inline double effectiveInverseMass(const BodyStore& bodies, const JointRows& rows, std::size_t row) {
    double sum = 0;
    for (std::size_t e = 0; e < rows.ends; ++e)
        sum += dot(rows.at(row, e), velocityChangeBy(bodies, rows.body[e], rows.at(row, e)));
    return sum;
}

inline void addLoad(JointLoad& load, const JointRows& rows, const Vec3& impulse) {
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Vec3& at = rows.row[r].at[1];
        const Vec2 along(at[0], at[1]);
        load.impulse += along * impulse[r];
        load.turning += (at[2] - cross(rows.arm[1], along)) * impulse[r];
    }
}

}  // namespace plumb
