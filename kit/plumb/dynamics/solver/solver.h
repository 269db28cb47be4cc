// SPDX-License-Identifier: MIT
// How are contacts and joints solved together?
//
// Each sub-step h: half of gravity and of the last impulses, solve with the position errors, move, the other half,
// relax without the position errors. In two halves around the move, motion under a steady force or on a joint's circle
// is right to second order in h, where gravity all at once leaves an error of a t h / 2.
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/fields/field_store.h>
#include <plumb/dynamics/joints/joint_island.h>
#include <plumb/dynamics/solver/joint_phases.h>

namespace plumb {

/// What the solver reads and writes.
struct SolverStores {
    ContactGraph& graph;
    const ContactStore& contacts;
    BodyStore& bodies;
    FieldStore& fields;
    const Space& space;
    const JointPhases* jointPhases = nullptr;  ///< if the world has joints
    JointStores joints;
    const SolverSettings& settings;
    StepObserver* observer = nullptr;  ///< if there is one
};

/// Moves the constrained bodies on by dt. A body that got no impulse is left where it was, for its closed form.
void solveConstraints(const SolverStores& stores, double dt);

}  // namespace plumb
