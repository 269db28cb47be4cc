// SPDX-License-Identifier: MIT
// What do gravity, fields and damping, all together, do to a velocity in a short time?
//
// dv/dt = b(v) - r(v) v, with r the sum of all rates of drag at a speed, and b of all pulls and flows. In the time t:
// v' = v e^(-r t) + b (1 - e^(-r t)) / r, with r and b of the speed half way, which is of second order, exact for
// linear drag, and steady at the terminal speed. Then friction takes off what it can, against the mean of the two, and
// no more than there is. Turning likewise. v velocity [m/s], r rate [1/s], b acceleration [m/s^2], t time [s]
// Tests: "a world's drag brings what falls to its terminal speed", "a puck on the ground stops where the formula says"
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// base: of gravity and outside forces.
FieldKick kickOf(const BodyRecord& body, const Acceleration& base, const FieldPull& pull,
                 const VelocityChange& velocity, double time);

inline VelocityChange sumOf(const FieldKick& kick) {
    VelocityChange sum = kick.kept;
    sum += kick.forced;
    sum += kick.damped;
    sum += kick.friction;
    return sum;
}

}  // namespace plumb
