// SPDX-License-Identifier: MIT
// How does a joint come into a world, and how does it leave?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Puts in a joint whose def was validated, and wakes its bodies.
JointIndex addJoint(WorldState& world, const JointDef& def);
/// Takes out a joint, and the gears that it drives, and wakes its bodies.
void removeJoint(WorldState& world, JointIndex joint);
/// Gives a joint that is there another def of its kind, which was validated, and wakes its bodies.
void changeJoint(WorldState& world, JointIndex joint, const JointDef& def);
/// Takes out all joints of a body, the hidden ones too.
void removeJointsOf(WorldState& world, BodyIndex body);
/// After the solver: takes out what bore too much, with an event.
void breakJoints(WorldState& world);

/// Holds a body along x, y, both or neither, where it is now.
void lockBody(WorldState& world, BodyIndex body, bool lockX, bool lockY);
/// A body was put elsewhere: its locks go with it.
void moveLocks(WorldState& world, BodyIndex body);
/// Joins a body that was put elsewhere with the nearest of what its joints hold, in a world that wraps.
void joinNearest(WorldState& world, BodyIndex body);
/// A body's centre of mass was shifted, in its own frame; its anchors stay where they are on it.
void shiftAnchors(WorldState& world, BodyIndex body, const Vec2& shift);

/// What other edits do to joints. A world calls these through this table, which its first joint puts in (see
/// solver/joint_phases.h).
struct JointEdits {
    void (*lock)(WorldState& world, BodyIndex body, bool lockX, bool lockY);
    /// A body was put elsewhere: its locks go with it, and in a world that wraps its joints take the nearest images.
    void (*followMove)(WorldState& world, BodyIndex body);
    void (*shiftAnchors)(WorldState& world, BodyIndex body, const Vec2& shift);
    void (*removeAllOf)(WorldState& world, BodyIndex body);
    void (*breakOverloaded)(WorldState& world);
};

extern const JointEdits jointEdits;

}  // namespace plumb
