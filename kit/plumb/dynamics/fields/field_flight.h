// SPDX-License-Identifier: MIT
// How does a body move through a step where there are fields?
//
// Before the step, the motion of every body on which a field may act is predicted by velocity Verlet at the sub-step,
// as if nothing touched the body. The result is stored as a closed form that leads to the same position. So all code
// that computes where a body will be, and when it hits something, needs to know nothing of fields. The velocity that
// the closed form misses is added at the step's end. After a bounce, the motion is predicted again from there. If only
// steady fields act on a body, its closed form is exact.
// Source: Verlet, Phys. Rev. 159 (1967) 98, as kick, drift, kick.
// Tests: "two bodies go round each other as Kepler says", "an orbit keeps its energy for 100 rounds", "a puck between
// walls 5 cm apart never speeds up, and stops when the formula says", "linear drag and wind carry a ball as the closed
// form says, to rounding"
#pragma once
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// In less time than this, a field's change of velocity is lost in rounding, and so is its law [s].
inline constexpr double shortestFieldStep = 1e-9;

/// At the start of a step of dt [s]: predicts the flights of all bodies on which fields act.
void predictFlights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt);

/// Predicts how a body on which fields act moves on for a time [s]. It is at from, at a time start [s] after the step's
/// start.
FieldFlight flightFrom(FieldStore& fields, const BodyStore& bodies, const Space& space, const PredictedFlight& before,
                       const BodyMotion& from, double start, double time);

/// At the end of a step: removes all flights and their accounts.
void clearFlights(FieldStore& fields, BodyStore& bodies);

}  // namespace plumb
