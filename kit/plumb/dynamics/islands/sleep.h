// SPDX-License-Identifier: MIT
// Which bodies may sleep? Those of an island in which all have been still for long enough.
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>
#include <plumb/space/space.h>

namespace plumb {

/// What putting to sleep reads and writes.
struct SleepStores {
    BodyStore& bodies;
    ContactGraph& graph;
    ContactStore& contacts;
    JointStore& joints;
    Space& space;
};

/// Puts a body to sleep with all that touches it or is joined to it, and so on; not what something moves that is awake.
void sleepIsland(const SleepStores& stores, BodyIndex body);
/// Counts how long each body has been still, and puts to sleep the islands in which all have been for long enough.
/// Returns their bodies.
std::vector<BodyIndex> sleepIslands(const SleepStores& stores, const SolverSettings& settings, double dt);

}  // namespace plumb
