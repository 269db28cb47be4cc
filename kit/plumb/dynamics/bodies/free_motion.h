// SPDX-License-Identifier: MIT
// Where is a body after a time in which nothing touches it?
//
// Without damping: x = x0 + v0 t + a t^2 / 2, v = v0 + a t.
// With dv/dt = a - k v: v = v0 e^-kt + a E, x = x0 + v0 E + a (t - E) / k, E = (1 - e^-kt) / k.
// x position [m], v velocity [m/s], a acceleration [m/s^2], k damping [1/s], t time [s]; the same for the angle.
// Source: textbook. Exact to rounding for any t.
// Test: "a thrown ball is where the formula says at every tick, at 60 Hz and at 20 Hz"
#pragma once
#include <vector>

#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/bodies/step_observer.h>

namespace plumb {

/// The law of a body's free motion in this step, with gravity, forces and fields.
FlightLaw flightLawOf(const BodyStore& bodies, BodyIndex body);
/// A body's state after a time of free motion [s]; a negative time goes back.
BodyMotion moveFreely(const BodyMotion& from, const FlightLaw& law, double time);

/// The factors of damped motion after a time: v = v0 keep + a gain, x = x0 + v0 gain + a reach.
struct Decay {
    double keep = 1;
    double gain = 0;   ///< [s]
    double reach = 0;  ///< [s^2]
};
Decay decay(double damping, double time);

/// The speed that the accelerations of two bodies make along a normal in half a step, of the body that gets more:
/// slower bounces are none (impact/detail/bounces.h). Joints may turn the pull on a body into any direction, so that of
/// a jointed body counts whole [m/s].
double restingSpeed(const BodyStore& bodies, BodyIndex a, BodyIndex b, const Vec2& normal);

/// Moves all bodies that neither impacts nor the solver move in this step of dt [s].
void moveFreeBodies(BodyStore& bodies, double dt, StepObserver* observer);

/// A body's free motion from one impact to the next.
struct TrajectorySegment {
    BodyIndex body = noBody;
    BodyMotion from, to;
    double start = 0, end = 0;  ///< since the start of the step [s]
};

/// Is it the time in which a stopped body stays where it is? It has its velocity all the same.
inline bool isStay(const TrajectorySegment& segment) {
    return segment.from.center == segment.to.center && segment.from.angle == segment.to.angle &&
           segment.from.velocity == segment.to.velocity;
}

/// The segments of all bodies; those of each body are in the order of time.
using Trajectories = std::vector<TrajectorySegment>;

// How has a body moved during a part of this step?

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
