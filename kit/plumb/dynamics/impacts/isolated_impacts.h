// SPDX-License-Identifier: MIT
// Which contacts are isolated impacts, and which are for the solver?
#pragma once
#include <plumb/dynamics/impacts/impact_group.h>

namespace plumb {

/// Moves the bodies whose contacts of this step are all isolated impacts, and takes those contacts out of the solver's
/// slots. All others stay there.
Impacts solveIsolatedImpacts(ContactGraph& graph, const ImpactStores& stores, double dt, double hitSpeed);

}  // namespace plumb
