// SPDX-License-Identifier: MIT
// Which contacts are isolated impacts: do their bodies meet in free motion, and do their bounces last longer than the
// step? Or do they spin, so that the solver could let them pass each other?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// The contacts of the solver that are isolated impacts, in the order of their shapes.
struct ImpactCandidates {
    StepList<ContactIndex> contacts;
    StepList<std::uint32_t> countOf;  ///< for each body: how many of them it has; empty if there are none

    /// Does the solver move this body: has it a joint, or a contact that is not an isolated impact?
    bool isConstrained(const BodyStore& bodies, BodyIndex body) const {
        const BodyLinks& links = bodies.links[body];
        return bodies.isDynamic(body) && (links.actingJoints > 0 || links.solverContacts > countOf[body]);
    }
};

/// Finds them for a step of dt [s]. The work grows with the number of contacts.
ImpactCandidates findImpactCandidates(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                      double dt);

}  // namespace plumb
