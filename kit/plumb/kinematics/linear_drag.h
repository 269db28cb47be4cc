// SPDX-License-Identifier: MIT
// Where is a point that is slowed by drag in proportion to its speed?
#pragma once
#include <plumb/kinematics/point_motion.h>

namespace plumb {

/// dv/dt = a - k (v - W)
struct DragLaw {
    double rate = 0;          ///< k, >= 0; the drag coefficient over the mass [1/s]
    Vec2 wind{0, 0};          ///< W, the velocity of the air [m/s]
    Vec2 acceleration{0, 0};  ///< a, by gravity and other constant forces [m/s^2]
};

/// The effect of a time step on a velocity v0 and an acceleration a: v = v0 keep + a gain, x = x0 + v0 gain + a reach.
struct DragStep {
    double keep = 1;   ///< e^(-k t) [-]
    double gain = 0;   ///< E = (1 - e^(-k t)) / k [s]
    double reach = 0;  ///< (t - E) / k [s^2]
};

/// Each within four units in its last place, for k t down to 0, where gain is t and reach is t^2 / 2.
/// Throws std::invalid_argument when rate k [1/s] or time t [s] is negative or not finite.
/// Test: "keep, gain and reach are those of long double, for k t from 1e-20 to 1e3"
DragStep dragStep(double rate, double time);
/// The same without its checks: a time that is infinite or NaN gives a result that is.
DragStep uncheckedDragStep(double rate, double time);

/// v = W + (v0 - W) keep + a gain,  x = x0 + W t + (v0 - W) gain + a reach: exact for any time.
/// x position [m], v velocity [m/s], the rest as in DragLaw and DragStep, t time, >= 0 [s].
/// Source: textbook; holds for drag proportional to the speed (small or slow objects; Stokes). Without drag it equals
/// moveAccelerated. Throws std::invalid_argument on a number that is not finite, and on a negative rate or time.
/// Test: "a point in wind and drag is where a fine Runge-Kutta takes it"
PointMotion moveWithDrag(const PointMotion& from, const DragLaw& law, double time);

}  // namespace plumb
