// SPDX-License-Identifier: MIT
// How has a body come through a part of this step?
#pragma once
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// A part of the step, counted back from its end [s].
struct Past {
    double from = 0, to = 0;
};

Sweep sweepBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record);
/// Of a body that the solver has not moved.
Sweep freeWay(const BodyStore& bodies, BodyIndex body, const Past& past);
/// Of any body, through the whole step of dt [s].
Sweep wayOf(const BodyStore& bodies, BodyIndex body, double dt);

/// No point of the body's outline has moved farther than this [m].
double travelOf(const Vec2& shift, double turn, const BodyRecord& record);
/// Is this so far for a body of its size that it may have gone through something?
bool isFar(const BodyRecord& record, double travel);
/// Has the body come so far in this step? Asked of all that moves, so nothing is worked out that need not be.
bool hasComeFar(const BodyStore& bodies, BodyIndex body, double dt);

}  // namespace plumb
