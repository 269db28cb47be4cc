// SPDX-License-Identifier: MIT
// How has a body moved during a part of this step?
#pragma once
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// A part of the step, counted from its start [s].
struct StepPart {
    double from = 0, to = 0;
};

Sweep sweepBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record);
/// The sweep of a wall during a part of the step, from its state at the step's start.
Sweep wallSweepOf(const BodyStore& bodies, BodyIndex wall, const StepPart& part);

/// An upper bound on how far a point of the body's outline has moved [m].
double travelOf(const Vec2& shift, double turn, const BodyRecord& record);

}  // namespace plumb
