// SPDX-License-Identifier: MIT
// Who changes a body's velocity in a sub-step? All but the kernels of contacts and swept joints do it here.
//
// Velocities, changes and impulses have three parts: along x, along y, turning.
#pragma once
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

inline Vec3 velocityOf(const BodyStore& bodies, BodyIndex body) {
    const SolverVelocity& v = bodies.velocity[body];
    return {static_cast<double>(v.x), static_cast<double>(v.y),
            static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration)};
}

/// The change of a body's velocity by an impulse, if the body is alone.
inline Vec3 velocityChangeBy(const BodyStore& bodies, BodyIndex body, const Vec3& impulse) {
    const double inverseMass = static_cast<double>(bodies.velocity[body].inverseMass);
    const double inverseGyration = static_cast<double>(bodies.turn[body].inverseGyration);
    return {inverseMass * impulse[0], inverseMass * impulse[1],
            inverseMass * inverseGyration * inverseGyration * impulse[2]};
}

/// Changes a velocity by what no contact gives: before changes, too, so that the change does not count as a contact's
/// (see solver_body.h).
inline void addVelocity(BodyStore& bodies, BodyIndex body, const Vec3& change) {
    SolverVelocity &v = bodies.velocity[body], &before = bodies.before[body];
    const auto add = [](float& to, float& mark, double more) {
        const float now = static_cast<float>(static_cast<double>(to) + more);
        mark += now - to;
        to = now;
    };
    add(v.x, before.x, change[0]);
    add(v.y, before.y, change[1]);
    add(v.w, before.w, change[2] * static_cast<double>(bodies.turn[body].gyration));
}

/// Writes the velocity of a body whose own is kept elsewhere, in doubles, with all that contacts have changed in it.
/// Number by number: a processor waits to read as a whole what was just written in parts (a doll took 5 % longer).
inline void setVelocity(BodyStore& bodies, BodyIndex body, const Vec3& velocity) {
    SolverVelocity &v = bodies.velocity[body], &before = bodies.before[body];
    before.x = v.x = static_cast<float>(velocity[0]);
    before.y = v.y = static_cast<float>(velocity[1]);
    before.w = v.w = static_cast<float>(velocity[2] * static_cast<double>(bodies.turn[body].gyration));
}

}  // namespace plumb
