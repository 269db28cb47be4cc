// SPDX-License-Identifier: MIT
// What do the fields do to a body: with which force do they pull it, which potential energy does it have in them, and
// how do gravity, fields and damping together change its velocity in a short time?
//
// dv/dt = b(v) - r(v) v, r the sum of all drag rates at a speed, b the sum of all pulls and flows. In the time t:
// v' = v e^(-r t) + b (1 - e^(-r t)) / r, with r and b at the mean speed. This is of second order, exact for linear
// drag, and steady at the terminal speed. Then friction reduces the velocity, against the mean of v and v', at most to
// 0. Turning is computed in the same way. v velocity [m/s], r rate [1/s], b acceleration [m/s^2], t time [s]
// Tests: "a world's drag brings what falls to its terminal speed", "a puck on the ground stops where the formula says"
#pragma once
#include <vector>

#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Sets pull to the sum of all fields' effects on a body. now: the motions of the bodies, by slot. Only this body's is
/// needed, but all of them if a field depends on other bodies (see dependsOnOtherBodies).
void pullOn(const FieldStores& view, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull);

/// Does the field have a potential energy?
bool hasEnergy(const FieldDef& field);
/// The potential energy of all bodies in all fields that have one [J].
double fieldEnergyOf(const FieldStores& view);
/// The potential energy of one body if it were at there, with all other bodies where they are now [J].
double fieldEnergyOf(const FieldStores& view, BodyIndex body, const BodyMotion& there);

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
