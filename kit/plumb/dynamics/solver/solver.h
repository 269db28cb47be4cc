// SPDX-License-Identifier: MIT
// How are contacts and joints solved together?
//
// Each sub-step h: apply half of gravity and of the last impulses, solve with the position errors, move, apply the
// other half, relax without the position errors. Because the forces act in two halves around the move, motion under a
// steady force or on a joint's circle is exact to second order in h. Applying gravity all at once would leave an error
// of a t h / 2.
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/fields/field_store.h>
#include <plumb/dynamics/jointed/joint_solver.h>
#include <plumb/dynamics/meetings/wall_impact.h>

namespace plumb {

/// The stores that the solver reads and writes.
struct SolverStores : MeetingStores {
    FieldStore& fields;
    JointStore& joints;
    JointSolver& jointSolver;
    const SolverSettings& settings;
    bool hasWalls = true;  ///< there are shapes of static or kinematic bodies
    double hitSpeed = 0;   ///< faster impacts are hits [m/s]
};

/// Moves the constrained bodies by dt [s]. A body that got no impulse is not moved here; it moves by its closed form
/// later. Returns the touches of bodies that were stopped at walls.
TouchEvents solveConstraints(SolverStores stores, double dt);

}  // namespace plumb
