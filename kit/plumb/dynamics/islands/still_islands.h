// SPDX-License-Identifier: MIT
// Which islands are still as a whole?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The stores that are read to find who may sleep, and written to put them to sleep.
struct SleepStores {
    BodyStore& bodies;
    ContactGraph& graph;
    ContactStore& contacts;
    JointStore& joints;
    Space& space;
};

/// The islands in which all bodies have been still for SolverSettings.sleepTime, and nothing is driven or carried. The
/// bodies that a body would wake, if it alone slept, belong to its island here, also if they do not touch it. In an
/// island that only a drive keeps awake, the bodies that are driven are watched again from now on: of the bodies it
/// writes how long they have been still.
StepList<StepList<BodyIndex>> findStillIslands(SleepStores& stores, const SolverSettings& settings);

}  // namespace plumb
