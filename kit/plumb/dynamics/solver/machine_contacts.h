// SPDX-License-Identifier: MIT
// How are the contacts of a machine solved, so that its joints hold at the same time?
//
// A machine is an island of joints that is solved directly. A contact that knows only the mass of the body which it
// touches is wrong for it: under a cart of a ton on wheels of a kilogram, each pass would give a thousandth of the
// impulse that is needed. So the speed of each contact is changed by the answer of the whole machine: the change of
// velocity of all its bodies by a unit impulse, with the joint impulses that follow from it. With these answers the
// contacts are solved one after the other, again and again, until nothing changes. Then the joints are solved again,
// from the contacts' impulses: where one of them has come to a stop, or a motor to its greatest force, the answers are
// others, and all is done once more.
// Source: projected Gauss-Seidel on the contacts of articulated bodies: Baraff, "Linear-time dynamics using Lagrange
// multipliers", SIGGRAPH 1996, section 6.
// Test: "a cart of a ton on wheels of a kilogram comes to rest"
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>

namespace plumb {

struct ContactGraph;
struct JointIsland;
struct JointIslands;

/// One half of a sub-step.
struct JointHalf {
    double step = 0;       ///< of the sub-step [s]
    bool correct = false;  ///< true in the half before the bodies move: corrects position errors too
    bool isFirst = false;  ///< of the step
};

/// A contact of which one body at least belongs to a machine.
struct MachineContact {
    /// Which body of which part it is; none: it cannot be moved.
    struct Side {
        std::uint32_t part = none, node = 0;
    };
    ContactIndex contact = none;
    Side a, b;
    // What the contact's lane holds, while it is hidden from the other contacts:
    float normal[2] = {}, tangent[2] = {}, roll = 0;  ///< impulses [N s, N m s]
    float normalMass[2] = {}, tangentMass[2] = {}, rollMass = 0;
};

/// What moves as one: a machine, or a single body.
struct MachinePart {
    JointIsland* island = nullptr;
    BodyIndex body = noBody;  ///< used without an island
};

struct MachineContacts {
    std::vector<MachineContact> contacts;
    std::vector<MachinePart> parts;
};

/// The inputs of one pass over the contacts of machines.
struct MachinePass {
    JointHalf half;
    ContactPass contacts, groundContacts;
};

/// Finds the contacts of this step that are solved together with the joints of their bodies.
MachineContacts takeMachineContacts(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                    JointIslands& islands);
/// Keeps them from being solved with all other contacts: moves their impulses and masses out of their lanes.
void hideMachineContacts(ContactGraph& graph, const ContactStore& contacts, MachineContacts& machines);

}  // namespace plumb
