// SPDX-License-Identifier: MIT
// How has a body moved during a part of this step?
#pragma once
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// A part of the step, counted back from its end [s].
struct Past {
    double from = 0, to = 0;
};

Sweep sweepBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record);
/// The sweep of a body that the solver has not moved, during a part of the step.
Sweep freeSweep(const BodyStore& bodies, BodyIndex body, const Past& past);
/// The sweep of any body, during the whole step of dt [s].
Sweep sweepOf(const BodyStore& bodies, BodyIndex body, double dt);

/// An upper bound on how far a point of the body's outline has moved [m].
double travelOf(const Vec2& shift, double turn, const BodyRecord& record);
/// Is this distance so long for the size of the body that it may have gone through something?
bool isFar(const BodyRecord& record, double travel);
/// Has the body moved so far in this step? This runs for every moving body, so it computes only what it needs.
bool hasMovedFar(const BodyStore& bodies, BodyIndex body, double dt);

}  // namespace plumb
