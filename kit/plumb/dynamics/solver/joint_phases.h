// SPDX-License-Identifier: MIT
// What do joints do in a step?
//
// A world calls the code of joints through this table, which its first joint sets. So the linker removes all code of
// joints from a program without joints. That is the table's only use: a page in a browser loads what is left.
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/solver/joint_bounces.h>
#include <plumb/dynamics/solver/machine_contacts.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

struct JointStore;
struct JointIslands;
struct JointStores;

struct JointPhases {
    /// Before the sub-steps of a step of dt [s]: finds the islands again if the joints have changed.
    void (*prepare)(const JointStores& stores, double dt);
    /// Before any force acts in a sub-step of h [s]: notes the speeds of springs and dampers.
    void (*noteSpeeds)(const JointStores& stores, double h);
    void (*solve)(const JointStores& stores, const JointHalf& half);
    /// Returns the contacts that bounce and have a jointed body, and keeps the solver from bouncing them again.
    std::vector<BounceGroup> (*takeBounces)(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                            const JointIslands& islands);
    /// Applies the impulses of those bounces that meet in the coming sub-step of h [s].
    void (*bounce)(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                   const std::vector<BounceGroup>& bounces, const std::vector<BodyIndex>& solved, double h);
    /// Returns the contacts of this step that are solved together with the joints of their bodies.
    MachineContacts (*takeMachines)(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                    JointIslands& islands);
    /// Before all other contacts are solved: keeps them from solving these.
    void (*hideMachines)(ContactGraph& graph, const ContactStore& contacts, MachineContacts& machines);
    /// After all other contacts are solved.
    void (*solveMachines)(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                          MachineContacts& machines, const MachinePass& pass);
    /// Removes the errors that contacts have caused in the joints' held rows.
    void (*hold)(const JointStores& stores, double h);
    /// For an island that is solved directly: applies an impulse (x, y, turning) to one body, and what its joints
    /// answer; or tells by how much that would change the body's velocity. h: of the sub-step [s]
    void (*push)(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse, double h);
    Vec3 (*answer)(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse, double h);
    /// After such impulses: removes the errors that they cause in the joints' held rows.
    void (*holdOne)(const JointStores& stores, JointIsland& island, double h);
    /// Adds the impulses of the step to the joints' loads.
    void (*addLoads)(JointStore& joints, const JointIslands& islands);
    double (*springEnergy)(const JointStore& joints, const BodyStore& bodies);  ///< [J]
};

extern const JointPhases jointPhases;

}  // namespace plumb
