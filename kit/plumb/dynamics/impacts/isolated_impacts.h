// SPDX-License-Identifier: MIT
// Which contacts are isolated impacts, and which ones are left to the solver?
#pragma once
#include <plumb/dynamics/impacts/impact_group.h>

namespace plumb {

/// Moves the bodies whose contacts in this step are all isolated impacts, and removes those contacts from the solver's
/// slots. All other contacts stay in the solver. Impacts faster than hitSpeed [m/s] are hits.
Impacts solveIsolatedImpacts(ContactGraph& graph, const ImpactStores& stores, double dt, double hitSpeed);

}  // namespace plumb
