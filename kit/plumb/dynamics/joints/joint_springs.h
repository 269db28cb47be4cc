// SPDX-License-Identifier: MIT
// How stiff may springs be within a sub-step, for a stable solution?
//
// A spring's force acts before and after each sub-step's motion, as gravity does: this is velocity Verlet, which keeps
// the energy. The method uses the stiffness k' = k F(q) / q, q = h^2 k w, F(q) = 4 sin^2(sqrt(q) / 2), so that a single
// spring swings at its own frequency to rounding. For springs that share a body, q is the sum over all of them, and F
// is limited to 1.8: no set of springs, however stiff, exceeds the method's limit of 4. A damper acts in both halves as
// well: first by the speed before, then by the speed after. This is of second order, stable for any damping, and exact
// for one damper alone.
// k stiffness [N/m], h sub-step [s], w effective inverse mass: change of its rate by a unit of its impulse [1/kg]
// Source: Hairer, Lubich, Wanner, "Geometric numerical integration illustrated by the Störmer-Verlet method", Acta
// Numerica 12 (2003) 399; k' makes the method's cosine of a sub-step's phase, 1 - h^2 k' w / 2, the exact one.
// Tests: "springs of 1 to 20 Hz swing at their own frequency", "springs of any stiffness do not blow up, many on one
// body neither"
#pragma once
#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

/// At the start of a step, for sub-steps of h [s]: finds the share F(q) / q of the springs' stiffness.
void shareSprings(JointIslands& found, JointStore& store, const BodyStore& bodies, double h);

/// What all springs between bodies in range hold [J].
double springEnergy(const JointStore& joints, const BodyStore& bodies);

}  // namespace plumb
