// SPDX-License-Identifier: MIT
// How does an impulse in a joint change the velocities of its bodies?
#pragma once
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

/// The change of the body's velocity (x, y, turn) by an impulse (x, y, turn).
inline Vec3 velocityChangeBy(const BodyStore& bodies, BodyIndex body, const Vec3& impulse) {
    const double inverseMass = static_cast<double>(bodies.velocity[body].inverseMass);
    const double inverseGyration = static_cast<double>(bodies.turn[body].inverseGyration);
    return {inverseMass * impulse[0], inverseMass * impulse[1],
            inverseMass * inverseGyration * inverseGyration * impulse[2]};
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

}  // namespace plumb
