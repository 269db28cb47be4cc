// SPDX-License-Identifier: MIT
// What do joints do in a step, and to the bodies that they hold?
//
// A world calls its joints through this table, which its first joint puts in. So the linker drops all code of joints
// from a program that makes none.
#pragma once
#include <vector>

#include <plumb/dynamics/detail/body_store.h>
#include <plumb/dynamics/detail/contact_store.h>

namespace plumb {

struct WorldState;

/// One half of a sub-step.
struct JointHalf {
    double step = 0;       ///< of the sub-step [s]
    bool correct = false;  ///< errors of position too: the half before the bodies move
};

struct JointSystem {
    /// Before the sub-steps of a step of dt [s].
    void (*prepare)(WorldState& world, double dt);
    /// Before any force acts in a sub-step of h [s]: notes how fast springs and dampers go.
    void (*noteSpeeds)(WorldState& world, double h);
    void (*solve)(WorldState& world, const JointHalf& half);
    /// The contacts that bounce and have a body that hangs on joints, which bounce() is to give their impulses.
    std::vector<ContactIndex> (*takeBounces)(WorldState& world);
    void (*bounce)(WorldState& world, const std::vector<ContactIndex>& contacts, const std::vector<BodyIndex>& solved,
                   double h);
    /// Takes out what contacts have done to what joints hold.
    void (*hold)(WorldState& world, double h);
    void (*tellLoads)(WorldState& world);
    /// After the solver: takes out what bore too much, with an event.
    void (*breakOverloaded)(WorldState& world);
    double (*springEnergy)(const WorldState& world);  ///< [J]

    /// Holds a body along x, y, both or neither, where it is now.
    void (*lock)(WorldState& world, BodyIndex body, bool lockX, bool lockY);
    /// A body was put elsewhere: its locks go with it, and in a world that wraps its joints take the nearest of what
    /// they hold.
    void (*followMove)(WorldState& world, BodyIndex body);
    /// A body's centre of mass was shifted, in its own frame: anchors stay where they are on it.
    void (*shiftAnchors)(WorldState& world, BodyIndex body, const Vec2& shift);
    void (*removeAllOf)(WorldState& world, BodyIndex body);
};

extern const JointSystem jointSystem;

}  // namespace plumb
