// SPDX-License-Identifier: MIT
// Which bodies may sleep? The bodies of an island in which all have been still for long enough.
//
// A body stays awake as long as one of these holds:
//   WorldDef.sleeping or its own canSleep is false,
//   it moves faster than SolverSettings.sleepSpeed, or was shifted by more than that in the step,
//   no contact or joint acts on it, and its velocity is not exactly 0: a body that floats or drifts never sleeps,
//   it touches, or is joined to, a kinematic body that is awake,
//   a belt that it touches moves it, or a joint's motor that has a target speed moves its bodies. A motor or belt that
//   something stops lets its bodies sleep,
//   no other movable body touches it or is joined to it, and it gained speed while it was slow: it begins to slide or
//   roll down a slope, or swings. It may sleep when it has lost nine tenths of that speed (stillness.h),
//   another body of its island has not been still for SolverSettings.sleepTime. A body that would wake it, if it alone
//   slept, counts as one of its island here, also if they do not touch: else two islands could wake each other for
//   ever, mutual gravity or a magnet that is awake acts on it, the program pushes it, moves it, or changes it or its
//   joints between steps, if only by a force of 0.
#pragma once
#include <plumb/dynamics/islands/still_islands.h>

namespace plumb {

/// Puts a body and its whole island to sleep: all bodies connected with it by contacts and joints. Does nothing if an
/// awake kinematic body touches the island or is joined to it. A body that is not dynamic is put to sleep alone.
void sleepIsland(SleepStores stores, BodyIndex body);
/// Counts how long each body has been still, and puts those islands to sleep in which all bodies have been still for
/// long enough. Returns the bodies that fell asleep.
StepList<BodyIndex> sleepIslands(SleepStores stores, const SolverSettings& settings, double dt);

}  // namespace plumb
