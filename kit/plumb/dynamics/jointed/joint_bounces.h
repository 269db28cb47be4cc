// SPDX-License-Identifier: MIT
// How do jointed bodies bounce?
//
// A body that moves freely bounces at the moment of contact (see impacts/isolated_impacts.h). The motion of a jointed
// body is constrained by its joints, so it bounces at the start of the sub-step in which it would meet another. The
// pairs are handled one by one, the fastest first, until none approaches. The impulse is the textbook's,
//   j = (1 + e) v / (n . response)
// where the response is that of the body's whole island to a unit impulse: so five discs on pendulums in a row
// pass an impact from one to the next. Friction is left to the solver.
// e restitution [-], v approach speed [m/s], n the contact's normal, response the change of the relative velocity
// [1/kg] Source: sequential impulses: Herrmann, Seitz, "How does the ball-chain work?", Am. J. Phys. 50 (1982) 977.
// Test: "of five hanging discs one swung sends one out, and two send two"
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

using BounceGroup = std::vector<ContactIndex>;

/// Returns the contacts of this step that bounce and have a jointed body, and keeps the solver from bouncing them
/// again. Contacts through which an impact may pass from one to the next are in one group.
std::vector<BounceGroup> takeJointedBounces(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                            const JointIslands& islands);
/// Before contacts are solved, in either half of a sub-step of h [s]: applies the impulses of those bounces that would
/// meet in this sub-step.
void bounceJointedBodies(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                         const std::vector<BounceGroup>& groups, double h);

}  // namespace plumb
