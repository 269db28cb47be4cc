// SPDX-License-Identifier: MIT
// How are joints added to a world, changed and removed?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Adds a joint whose def was validated, and wakes its bodies. solver: of which the world gets a copy, if it is the
/// first joint (joint_solver.h).
JointIndex addJoint(WorldState& world, const JointDef& def, const JointSolver& solver);
/// Removes a joint, and the gears that it drives, and wakes its bodies.
void removeJoint(WorldState& world, JointIndex joint);
/// Gives an existing joint another def of its kind, which was validated, and wakes its bodies.
void changeJoint(WorldState& world, JointIndex joint, const JointDef& def);
/// Removes all joints of a body, the hidden ones too.
void removeJointsOf(WorldState& world, BodyIndex body);
/// After the solver: removes the joints whose load exceeds their limits, with an event for each.
void breakJoints(WorldState& world);

/// Locks a body along x, y, both or neither, at its present position.
void lockBody(WorldState& world, BodyIndex body, bool lockX, bool lockY, const JointSolver& solver);
/// After a body was moved by an edit: moves its locks, and in a world that wraps connects its joints to the nearest
/// images of the other bodies.
void followMove(WorldState& world, BodyIndex body);
/// After a body's centre of mass was shifted, in its own frame: corrects the anchors, so that they stay at the same
/// points of the body.
void shiftAnchors(WorldState& world, BodyIndex body, const Vec2& shift);

}  // namespace plumb
