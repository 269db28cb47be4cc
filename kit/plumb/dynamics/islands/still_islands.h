// SPDX-License-Identifier: MIT
// Which islands are still as a whole?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The stores that the search for still islands reads. Of the bodies it writes how long they have been still.
struct IslandView {
    BodyStore& bodies;
    const ContactStore& contacts;
    const JointStore& joints;
    const Space& space;
};

/// The islands in which all bodies have been still for SolverSettings.sleepTime, and nothing is driven or carried. The
/// bodies that a body would wake, if it alone slept, belong to its island here, also if they do not touch it. In an
/// island that only a drive keeps awake, the bodies that are driven are watched again from now on.
StepList<StepList<BodyIndex>> findStillIslands(const IslandView& view, const SolverSettings& settings);

}  // namespace plumb
