// SPDX-License-Identifier: MIT
// What do contacts do to velocities?
//
// A point of contact with normal n (from A to B), tangent t = perp(n), anchors r in the contact's frame times rho:
//   vn = n.(vB - vA) - rtB wB + rtA wA          speed at which it opens
//   vt = t.(vB - vA) + rnB wB - rnA wA + belt   speed at which B's surface slides along t
//   1/kn = mA (1 + rtA^2) + mB (1 + rtB^2)      effective inverse mass (mA, mB inverse masses), kt with rn
//   s = s0 + n.(dB - dA) + rotation terms       separation after the displacements dA, dB
// Solve pushes vn to at least -s/h, so that the points just meet, or, once they overlap, apart at the soft rate; relax
// takes that push out of the velocity again. Friction is held to mu times the normal impulse, a torque against rolling
// to its reach times that.
// Source: Catto, "Iterative dynamics with temporal coherence", GDC 2005, and "Solver2D", 2024.
#pragma once
#include <cstddef>

#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

struct ContactPass {
    float inverseStep = 0;  ///< 1/h [1/s]
    Softness soft;
    float pushSpeed = 0;  ///< the fastest that overlap is pushed out [m/s]
};

/// The same four functions for each number of lanes, with the same results to the last bit.
struct ContactSolver {
    /// Adds the impulses of the last step to what each body is given at every half sub-step.
    void (*gatherWarmStart)(const ContactBatch* batches, std::size_t count, const SolverBodies& bodies);
    /// With the push out of overlap; separations as they stand.
    void (*solve)(ContactBatch* batches, std::size_t count, const SolverBodies& bodies, const ContactPass& pass);
    /// Without it, at separations computed anew from the displacements.
    void (*relax)(ContactBatch* batches, std::size_t count, const SolverBodies& bodies, const ContactPass& pass);
    /// At the step's end: what came fast enough leaves at its share of the speed.
    void (*bounce)(ContactBatch* batches, std::size_t count, const SolverBodies& bodies);
};

/// One lane after the other: the reference, short enough to teach from.
extern const ContactSolver scalarContactSolver;

template <int W>
struct WideContactSolver {
    static const ContactSolver code;
};

/// For at most so many lanes, as the machine can.
const ContactSolver& contactSolver(int lanes);

}  // namespace plumb
