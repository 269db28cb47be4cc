// SPDX-License-Identifier: MIT
// How long has each body been still?
//
// A body is slow if it, and the shift by the solver, is slower than SolverSettings.sleepSpeed. While it is slow it is
// watched. Jitter moves a body to and fro, so speeds are means over parts of the watch, from the distance between
// places. If the mean speed rises, something drives the body on: gravity down a slope, or back from the end of a swing.
// It counts as still again when it has lost most of the speed that it gained.
//
// Tried and lost: a bound on the distance moved in the watch. Heaps that settle and discs that roll out move farther
// in it than a pendulum of 5 mm or a disc on a slope of 0.01 degrees.
#pragma once
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/solver_settings.h>

namespace plumb {

/// Counts the time of all awake dynamic bodies, after a step of dt [s]. Returns whether any has been still for
/// SolverSettings.sleepTime.
bool countStillness(BodyStore& bodies, const SolverSettings& settings, double dt);

}  // namespace plumb
