// SPDX-License-Identifier: MIT
// Which data of each body do the narrow phase and the solver need in this step?
#pragma once
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// Converts the state of a body to the floats of the narrow phase and the solver, for a step of dt [s]: at the start of
/// the step if it is awake, or as it wakes up. A body whose numbers are out of range is marked for quarantine and
/// treated as at rest.
void loadBody(BodyStore& bodies, BodyIndex body, double dt);
/// If x^2 + y^2 + w^2 of its velocity is below this, a body moves by less than farShare of its inradius in a step of
/// dt [m^2/s^2]: a point of the outline moves by at most (|v| + |w| r) t in a time t, r the turning radius divided by
/// that of gyration, and so by at most max(1, r) sqrt(2 (v^2 + w^2)) t.
float farSpeedSquared(const BodyRecord& body, double dt);
/// What is compared with it.
inline float speedSquared(const SolverVelocity& v) {
    return v.x * v.x + v.y * v.y + v.w * v.w;
}

}  // namespace plumb
