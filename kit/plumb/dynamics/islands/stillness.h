// SPDX-License-Identifier: MIT
// How long has each body been still, and what drives it, so that it may not sleep although it is slow?
//
// A body is slow if it, and the shift by the solver, is slower than SolverSettings.sleepSpeed. While it is slow it is
// watched. If only fixed bodies touch it or are joined to it, it must not gain speed: gravity drives it down a slope,
// or back from the end of its swing. Speeds are means over parts of the watch, from the distance between places,
// because jitter moves a body to and fro. A body counts as still again when it has lost most of the speed that it
// gained. A body that comes slow to the end of an undamped swing has the speed from before.
//
// Tried and lost: the same for bodies among others. The slow waves in stacks and heaps are as fast as a pendulum of 5
// mm, and pyramids slept up to 15 times later. A bound on the distance moved: heaps that settle move farther than that.
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// Counts the time of all awake dynamic bodies, after a step of dt [s]. Returns whether any has been still for
/// SolverSettings.sleepTime.
bool countStillness(BodyStore& bodies, const ContactStore& contacts, const JointStore& joints,
                    const SolverSettings& settings, double dt);

/// Does an awake kinematic body touch this body, or is it joined to it?
bool isCarried(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body);
/// Does a belt move the body (see Material.surfaceSpeed), or a motor that runs? A body that such a drive cannot move,
/// as something is in its way, is not driven.
bool isDriven(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints,
              const SolverSettings& settings, BodyIndex body);

}  // namespace plumb
