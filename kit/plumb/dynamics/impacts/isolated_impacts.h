// SPDX-License-Identifier: MIT
// What happens to bodies that bounce, and meet one other at a time? Each impact is solved at the moment it happens, by
// the closed form. Everything else is left to the solver.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/impacts/flying_bodies.h>

namespace plumb {

/// The results of all impacts of a step.
struct Impacts {
    Trajectories trajectories;
    TouchEvents touches;
};

/// Moves the bodies whose contacts in this step are all isolated impacts, and removes those contacts from the solver's
/// slots. All other contacts stay in the solver. Impacts faster than hitSpeed [m/s] are hits.
Impacts solveIsolatedImpacts(ContactGraph& graph, const ImpactStores& stores, double dt, double hitSpeed);

}  // namespace plumb
