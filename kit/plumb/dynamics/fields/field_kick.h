// SPDX-License-Identifier: MIT
// How do gravity, fields and damping together change a velocity in a short time?
//
// dv/dt = b(v) - r(v) v, r the sum of all drag rates at a speed, b the sum of all pulls and flows. In the time t:
// v' = v e^(-r t) + b (1 - e^(-r t)) / r, with r and b at the mean speed. This is of second order, exact for linear
// drag, and steady at the terminal speed. Then friction reduces the velocity, against the mean of v and v', at most to
// 0. Turning is computed in the same way. v velocity [m/s], r rate [1/s], b acceleration [m/s^2], t time [s]
// Tests: "a world's drag brings what falls to its terminal speed", "a puck on the ground stops where the formula says"
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// base: the acceleration by gravity and applied forces.
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
