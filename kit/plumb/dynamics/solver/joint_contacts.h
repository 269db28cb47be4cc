// SPDX-License-Identifier: MIT
// How are contacts solved again, where they have brought a joint to a stop or off it?
//
// Contacts see a light wheel under a cart with half of the cart's mass, or with its own, depending on whether its
// suspension is at a stop (see joints/lanes/island_response_wide.h). If the joints' answer to the contacts changes
// that, the contacts of this island are solved again, with the new masses, from their present impulses, and so on until
// nothing changes.
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

/// The passes of one half of a sub-step.
struct HalfPass {
    bool correct = false;
    ContactPass contacts, groundContacts;
};

/// A contact that may have to be solved again, and its impulses before this half.
struct JointedContact {
    JointBatch* batch = nullptr;
    std::size_t lane = 0;  ///< in that batch
    ContactIndex contact = none;
    ContactGiven start{};
};

/// The contacts of this step that may have to be solved again.
std::vector<JointedContact> findJointedContacts(JointIslands& islands, const ContactGraph& graph, const ContactStore& contacts,
                                                const BodyStore& bodies);
/// At the start of a half: notes the impulses.
void noteStart(std::vector<JointedContact>& jointed, const ContactGraph& graph, const ContactStore& contacts);
/// Takes back the impulses of this half, where islands have changed.
void takeBack(const std::vector<JointedContact>& jointed, ContactGraph& graph, const ContactStore& contacts,
              BodyStore& bodies);
/// Solves those contacts again whose islands have changed.
void solveContactsAgain(const std::vector<JointedContact>& jointed, ContactGraph& graph, const ContactStore& contacts,
                        BodyStore& bodies, const HalfPass& pass);

}  // namespace plumb
