// SPDX-License-Identifier: MIT
// How do bodies bounce that hang on joints?
//
// What flies free bounces at the moment it meets (see impacts.h). A body that hangs on joints goes where they let it,
// and so bounces at the start of the sub-step in which it would meet: pair after pair, those that come together fastest
// first, until none approaches. The impulse is that of the lecture, j = (1 + e) v / (n . answer), where the answer to a
// unit impulse is that of the body's whole island: so five discs that hang in a row hand a blow on from one to the
// next. e restitution [-], v approach speed [m/s], n the contact's normal, answer the change of the relative velocity
// [1/kg] Friction is left to the solver. Source: sequential impulses: Herrmann, Seitz, "How does the ball-chain work?",
// Am. J. Phys. 50 (1982) 977. Test: "of five hanging discs one swung sends one out, and two send two"
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The contacts of this step that bounce and have a jointed body: the solver is not to bounce them again.
std::vector<ContactIndex> takeJointedBounces(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                             const JointIslands& islands);
/// Before contacts are solved, in either half of a sub-step of h [s]: gives those their impulses that would meet in the
/// one that comes.
void bounceJointedBodies(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                         const std::vector<ContactIndex>& bounces, double h);

}  // namespace plumb
