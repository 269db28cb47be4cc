// SPDX-License-Identifier: MIT
// Which shapes were put into each other?
//
// An editor or a spawner may put bodies where others are. If the springs of contacts pushed them out, they would get
// speed, and in a crowd the speeds add up: it bursts. So a contact is noted that is deep in overlap after one of its
// bodies has been placed. Its spring sees a small overlap only, and the rest is shifted apart (loads/push_apart.h).
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>

namespace plumb {

/// Notes the contacts in the solver that are deep in overlap, of bodies that have been placed since the last step.
/// Measures the noted contacts, whose separations are those at the step's start, and hides their overlap from the
/// solver. Forgets those that have come apart.
void measureOverlaps(ContactStore& contacts, ContactGraph& graph, const BodyStore& bodies);

}  // namespace plumb
