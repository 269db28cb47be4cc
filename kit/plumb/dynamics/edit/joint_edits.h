// SPDX-License-Identifier: MIT
// How are joints added to a world, changed and removed?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Adds a joint whose def was validated, and wakes its bodies.
JointIndex addJoint(WorldState& world, const JointDef& def);
/// Removes a joint, and the gears that it drives, and wakes its bodies.
void removeJoint(WorldState& world, JointIndex joint);
/// Gives an existing joint another def of its kind, which was validated, and wakes its bodies.
void changeJoint(WorldState& world, JointIndex joint, const JointDef& def);
/// Removes all joints of a body, the hidden ones too.
void removeJointsOf(WorldState& world, BodyIndex body);
/// After the solver: removes the joints whose load exceeds their limits, with an event for each.
void breakJoints(WorldState& world);

/// Locks a body along x, y, both or neither, at its present position.
void lockBody(WorldState& world, BodyIndex body, bool lockX, bool lockY);
/// Moves the locks of a body to its new position, after the body was moved by an edit.
void moveLocks(WorldState& world, BodyIndex body);
/// In a world that wraps: after a body was moved by an edit, connects its joints to the nearest images of the other
/// bodies.
void takeNearestImages(WorldState& world, BodyIndex body);
/// After a body's centre of mass was shifted, in its own frame: corrects the anchors, so that they stay at the same
/// points of the body.
void shiftAnchors(WorldState& world, BodyIndex body, const Vec2& shift);

/// The edits of joints that other edits need. A world calls them through this table, which its first joint sets (see
/// jointed/joint_phases.h).
struct JointEdits {
    void (*lock)(WorldState& world, BodyIndex body, bool lockX, bool lockY);
    /// After a body was moved by an edit: moves its locks, and in a world that wraps connects its joints to the nearest
    /// images.
    void (*followMove)(WorldState& world, BodyIndex body);
    void (*shiftAnchors)(WorldState& world, BodyIndex body, const Vec2& shift);
    void (*removeAllOf)(WorldState& world, BodyIndex body);
    void (*breakOverloaded)(WorldState& world);
};

extern const JointEdits jointEdits;

}  // namespace plumb
