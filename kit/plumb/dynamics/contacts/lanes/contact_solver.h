// SPDX-License-Identifier: MIT
// How do contacts change the velocities of bodies?
//
// vn, vt, s: see point_kinematics.h; to vt the belt's surfaceSpeed is added; h sub-step [s], mu friction [-].
// solve makes vn at least -s/h, so that the points just meet; if they overlap, it pushes them apart at the soft rate.
// relax removes this push from the velocity again. The two points of a contact are solved together (two_points.h).
// Friction is limited to mu times the normal impulse, and the torque against rolling to rollingArm times the normal
// impulse.
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
    float pushSpeed = 0;  ///< the highest speed at which overlap is pushed out [m/s]
};

/// One for contacts of two bodies that move, one for those with a fixed one.
struct ContactPasses {
    ContactPass loose, ground;
    const ContactPass& of(bool isGround) const { return isGround ? ground : loose; }
};

/// Four functions for the first `contacts` lanes of consecutive batches, with results that are equal to the last bit
/// for each number of lanes.
struct ContactSolver {
    /// Adds the velocity changes by the last step's impulses to SolverBodies.warm, which every half sub-step applies.
    void (*gatherWarmStart)(const ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies);
    /// Solves with the push out of overlap, at the stored separations.
    void (*solve)(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies, const ContactPass& pass);
    /// Solves without that push, at separations that are computed again from the displacements.
    void (*relax)(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies, const ContactPass& pass);
    /// At the step's end: makes the points part at their bounceSpeed, if they have pushed in this step.
    void (*bounce)(ContactBatch* batches, std::size_t contacts, const SolverBodies& bodies);
};

template <int W>
struct WideContactSolver {
    static const ContactSolver code;
};

/// The solver for the largest number of lanes that the machine supports, at most `lanes`; that for one solves contacts
/// one after the other, so they may share bodies.
const ContactSolver& contactSolver(int lanes);

}  // namespace plumb
