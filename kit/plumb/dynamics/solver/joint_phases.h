// SPDX-License-Identifier: MIT
// What do joints do in a step?
//
// A world calls its joints through this table, which its first joint puts in. So the linker drops all code of joints
// from a program that makes none.
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

struct JointStore;
struct JointIslands;
struct JointStores;

/// One half of a sub-step.
struct JointHalf {
    double step = 0;       ///< of the sub-step [s]
    bool correct = false;  ///< errors of position too: the half before the bodies move
};

struct JointPhases {
    /// Before the sub-steps of a step of dt [s]: finds the islands anew if they have changed.
    void (*prepare)(const JointStores& stores, double dt);
    /// Before any force acts in a sub-step of h [s]: notes how fast springs and dampers go.
    void (*noteSpeeds)(const JointStores& stores, double h);
    void (*solve)(const JointStores& stores, const JointHalf& half);
    /// The contacts that bounce and have a jointed body: the solver is not to bounce them again.
    std::vector<ContactIndex> (*takeBounces)(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                             const JointIslands& islands);
    /// Gives those contacts their impulses that meet in the coming sub-step of h [s].
    void (*bounce)(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                   const std::vector<ContactIndex>& bounces, const std::vector<BodyIndex>& solved, double h);
    /// Takes out what contacts have done to what joints hold.
    void (*hold)(const JointStores& stores, double h);
    /// Adds what the step's impulses were to the joints' loads.
    void (*addLoads)(JointStore& joints, const JointIslands& islands);
    double (*springEnergy)(const JointStore& joints, const BodyStore& bodies);  ///< [J]
};

extern const JointPhases jointPhases;

}  // namespace plumb
